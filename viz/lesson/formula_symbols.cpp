// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/formula_symbols.h"

#include <map>

namespace psm {
namespace {

using Role = Formula::Role;

const std::map<std::string, FormulaSymbol>& commands() {
  static const std::map<std::string, FormulaSymbol> table{{"alpha", {"α", Role::ordinary, true}},
                                                          {"beta", {"β", Role::ordinary, true}},
                                                          {"gamma", {"γ", Role::ordinary, true}},
                                                          {"delta", {"δ", Role::ordinary, true}},
                                                          {"epsilon", {"ε", Role::ordinary, true}},
                                                          {"varepsilon", {"ε", Role::ordinary, true}},
                                                          {"zeta", {"ζ", Role::ordinary, true}},
                                                          {"eta", {"η", Role::ordinary, true}},
                                                          {"theta", {"θ", Role::ordinary, true}},
                                                          {"iota", {"ι", Role::ordinary, true}},
                                                          {"kappa", {"κ", Role::ordinary, true}},
                                                          {"lambda", {"λ", Role::ordinary, true}},
                                                          {"mu", {"μ", Role::ordinary, true}},
                                                          {"nu", {"ν", Role::ordinary, true}},
                                                          {"xi", {"ξ", Role::ordinary, true}},
                                                          {"pi", {"π", Role::ordinary, true}},
                                                          {"rho", {"ρ", Role::ordinary, true}},
                                                          {"sigma", {"σ", Role::ordinary, true}},
                                                          {"tau", {"τ", Role::ordinary, true}},
                                                          {"upsilon", {"υ", Role::ordinary, true}},
                                                          {"phi", {"φ", Role::ordinary, true}},
                                                          {"varphi", {"φ", Role::ordinary, true}},
                                                          {"chi", {"χ", Role::ordinary, true}},
                                                          {"psi", {"ψ", Role::ordinary, true}},
                                                          {"omega", {"ω", Role::ordinary, true}},
                                                          {"Gamma", {"Γ"}},
                                                          {"Delta", {"Δ"}},
                                                          {"Theta", {"Θ"}},
                                                          {"Lambda", {"Λ"}},
                                                          {"Xi", {"Ξ"}},
                                                          {"Pi", {"Π"}},
                                                          {"Sigma", {"Σ"}},
                                                          {"Upsilon", {"Υ"}},
                                                          {"Phi", {"Φ"}},
                                                          {"Psi", {"Ψ"}},
                                                          {"Omega", {"Ω"}},
                                                          {"cdot", {"·", Role::binary}},
                                                          {"times", {"×", Role::binary}},
                                                          {"pm", {"±", Role::binary}},
                                                          {"cap", {"∩", Role::binary}},
                                                          {"cup", {"∪", Role::binary}},
                                                          {"circ", {"∘", Role::binary}},
                                                          {"le", {"≤", Role::relation}},
                                                          {"leq", {"≤", Role::relation}},
                                                          {"ge", {"≥", Role::relation}},
                                                          {"geq", {"≥", Role::relation}},
                                                          {"ne", {"≠", Role::relation}},
                                                          {"neq", {"≠", Role::relation}},
                                                          {"approx", {"≈", Role::relation}},
                                                          {"to", {"→", Role::relation}},
                                                          {"in", {"∈", Role::relation}},
                                                          {"perp", {"⊥", Role::relation}},
                                                          {"infty", {"∞"}},
                                                          {"ldots", {"…"}},
                                                          {"dots", {"…"}},
                                                          {"sum", {"∑", Role::function}},
                                                          {"sin", {"sin", Role::function}},
                                                          {"cos", {"cos", Role::function}},
                                                          {"tan", {"tan", Role::function}},
                                                          {"arctan", {"arctan", Role::function}},
                                                          {"ln", {"ln", Role::function}},
                                                          {"log", {"log", Role::function}},
                                                          {"max", {"max", Role::function}},
                                                          {"min", {"min", Role::function}},
                                                          {"det", {"det", Role::function}},
                                                          {"{", {"{", Role::opening}},
                                                          {"}", {"}", Role::closing}},
                                                          {"|", {"‖"}}};
  return table;
}

const std::map<char, FormulaSymbol>& characters() {
  static const std::map<char, FormulaSymbol> table{{'+', {"+", Role::binary}},
                                                   {'-', {"−", Role::binary}},
                                                   {'=', {"=", Role::relation}},
                                                   {'<', {"<", Role::relation}},
                                                   {'>', {">", Role::relation}},
                                                   {'(', {"(", Role::opening}},
                                                   {')', {")", Role::closing}},
                                                   {'[', {"[", Role::opening}},
                                                   {']', {"]", Role::closing}},
                                                   {'|', {"|"}},
                                                   {',', {",", Role::punctuation}},
                                                   {';', {";", Role::punctuation}},
                                                   {':', {":", Role::relation}},
                                                   {'.', {"."}},
                                                   {'/', {"/"}},
                                                   {'\'', {"′"}}};
  return table;
}

template <class Key>
const FormulaSymbol* find(const std::map<Key, FormulaSymbol>& table, const Key& key) {
  const auto found = table.find(key);
  return found == table.end() ? nullptr : &found->second;
}

}  // namespace

const FormulaSymbol* symbol_of_command(const std::string& name) { return find(commands(), name); }
const FormulaSymbol* symbol_of_character(char c) { return find(characters(), c); }

}  // namespace psm
