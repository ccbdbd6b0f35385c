# SPDX-License-Identifier: GPL-3.0-or-later
# What app/run and tests/run share: the packages and the build. Sourced; everything it prints goes to standard error.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

fail() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# Names of the packages of these groups that are not installed.
missing_packages() {
  local group package reason wanted=" $* "
  while read -r group package reason; do
    [[ $group == \#* || $wanted != *" $group "* ]] && continue
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || echo "$package"
  done <"$root/app/packages.txt"
}

install_packages() {
  command -v dpkg-query >/dev/null || fail "this is not Debian: install what app/packages.txt lists by hand, then build with cmake"
  local missing as_root=()
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0
  if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "neither root nor sudo; as root: apt-get install --no-install-recommends ${missing[*]}"
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}" >&2
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300)
  # A failed update is not the end: the lists that are there may do.
  "${apt[@]}" update </dev/null >&2 || echo "apt-get update failed; going on with the package lists that are there" >&2
  "${apt[@]}" install --no-install-recommends "${missing[@]}" </dev/null >&2 || fail "apt-get could not install ${missing[*]}"
}

# Arguments go to cmake. Release, in build/release.
configure() { (cd "$root" && cmake --preset release "$@") </dev/null >&2 || fail "configuring failed"; }

# Arguments go to cmake --build.
build() { (cd "$root" && cmake --build --preset release -j "$(nproc)" "$@") </dev/null >&2 || fail "building failed"; }
