#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers of hard_cases.csv, derived apart from the program's code, with 60 digits (needs python3-mpmath).

Prints number;case;quantity;answer for each. Inputs are the doubles that the program takes; what is done with them follows the
papers' formulas (lambda as printed, angles instead of sines, the window as a plain affine map), not viz/math.
"""
import math
from mpmath import mp, mpf, sqrt, tan, atan, sin, cos, pi, hypot

mp.dps = 60
K = 57.29577951308232  # degrees in a radian, as a double
out = {}


def say(number, case, quantity, value):
    out[number, case, quantity] = mpf(value)


# ---- the model of GMNPR 2007 ---------------------------------------------------------------------------------------------
n, f, phi = mpf(1), mpf(100), pi / 6


def rad(degrees):
    return mpf(degrees) * pi / 180


def gmnpr(theta, f=f):
    if theta >= phi:  # Eq. 4
        W = (f - n) * sin(theta) + (f + n) * cos(theta) * tan(phi)
        t_min = n * (sin(theta) - cos(theta) * tan(phi))
        return (sqrt(f * n) * sin(theta) + t_min) / W
    return sqrt(n / f) / (2 * tan(pi * theta / (4 * phi)))  # Eq. 7


def E(z, lam, theta, f=f):  # F sin(theta) on the central line; lam = inf: uniform
    S, C = sin(theta), cos(theta) * tan(phi)
    W = (f - n) * S + (f + n) * C if theta >= phi else 2 * f * C
    t_min = (n if theta >= phi else f) * (S - C)
    if lam == mp.inf:
        return W / (z * tan(phi))
    P = lam * W - t_min + z * S  # distance from the vanishing plane
    return P * P / (lam * (lam + 1) * W) / (z * tan(phi))


g90 = gmnpr(pi / 2)
say(1, 'theta = 90 deg', 'lambda of GMNPR', g90)
say(1, 'theta = 90 deg', 'F(n) / F(f) of GMNPR', E(n, g90, pi / 2) / E(f, g90, pi / 2))
for side in ('theta = phi, from above;lambda of GMNPR, Eq. 4', 'theta = phi, from below;lambda of GMNPR, Eq. 7, one rounding below phi'):
    say(2, *side.split(';'), gmnpr(phi))
over = 30 + 1e-12 * K
say(3, 'theta = phi +- 1e-12 rad', 'jump of lambda of GMNPR over the step', abs(gmnpr(rad(over)) - gmnpr(rad(30 - 1e-12 * K))))


def glpr(theta):
    return n * sin(theta - phi) / ((f - n) * sin(theta) * cos(phi) + (f + n) * cos(theta) * sin(phi))


say(3, 'theta = phi + 1e-12 rad', 'lambda of GLPR, from degrees', glpr(rad(over)))
say(3, 'the same, from vectors', 'lambda of GLPR, S - C cancels', glpr(phi + mpf(1e-12)))
say(4, 'theta = 0, any axis', 'E(n) of the uniform map, 2 f / n', E(n, mp.inf, mpf(0)))
tiny = rad(1e-12 * K)
say(5, 'theta = 1e-12 rad', '1 - rho of GMNPR', 1 / (1 + gmnpr(tiny)))
say(5, 'theta = 1e-12 rad', 'largest E on the central line, finite', max(E(n, gmnpr(tiny), tiny), E(f, gmnpr(tiny), tiny)))
theta0 = atan(tan(phi) * sqrt(f) / (sqrt(f) + sqrt(n)))
say(6, 'theta0 = 27.6934 deg', 'theta0, where Eq. 4 ends, deg', theta0 * 180 / pi)
over0 = rad(float(theta0 * 180 / pi) + 1e-9)
say(6, 'theta0 + 1e-9 deg', 'lambda of Eq. 4', (f + sqrt(f * n)) / (2 * f) * tan(over0) / tan(phi) - mpf(1) / 2)
deep, low = mpf(800), rad(20)
say(7, 'f = 800, theta = 20 deg', 'F_max of GMNPR over that of the uniform map',
    max(E(z, gmnpr(low, deep), low, deep) for z in (n, deep)) / max(E(z, mp.inf, low, deep) for z in (n, deep)))
near_1 = mpf(1.000001)
case8 = 'f = 1.000001, theta = 90 deg'
say(8, case8, 'lambda of GMNPR', gmnpr(pi / 2, near_1))
say(8, case8, 'rho of GMNPR, which is what maps are made of', 1 / (1 + 1 / gmnpr(pi / 2, near_1)))
say(9, 'f = 1e8, theta = 90 deg', 'lambda of GMNPR', gmnpr(pi / 2, mpf(10) ** 8))
for shift in (5, 20):
    lam = mpf(n + shift) / (f - n)
    say(31, f'shift by {shift}, theta = 90 deg', 'F_max', max(E(n, lam, pi / 2), E(f, lam, pi / 2)))
for shift, name in ((0, '0 (PSM)'), (5, '5'), (10, '10 (LiSPSM)')):
    say(32, f'shift by {name}, theta = 90 deg', 'storage factor, (f - n) / (n tan phi)', (f - n) / (n * tan(phi)))
say(37, 'z0 = -1, z1 = 100', 'rho of LiSPSM with z0 held at the near distance 0.1', sqrt(mpf(0.1) / 100))
for name in ('tan(phi_eff) / tan(phi)', 'the same in an analysis'):
    say(29, 'square frustum, diagonal light', name, sqrt(2))

# ---- maps: a camera that looks along -z --------------------------------------------------------------------------------------
TAN = 0.57735026918962576


def receivers(eye):  # in doubles, as the program makes them
    add = lambda x, y, z: [eye[0] + z * (0.0 + TAN * (x * 1.0 + y * 0.0)), eye[1] + z * (0.0 + TAN * (x * 0.0 + y * 1.0)), eye[2] + z * -1.0]
    points = [add(x, y, z) for z in (1.0, 100.0) for x in (-1.0, 1.0) for y in (-1.0, 1.0)]
    return points + [add(0.3 * (i % 3) - 0.35, 0.4 * (i % 4) - 0.7, math.pow(100.0, (i + 0.5) / 12)) for i in range(12)]


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), mpf(0))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def psm(light, points, eye):
    """(u, v) of the points: centre-aimed PSM, c = q.w - kappa k.q, window around the points."""
    l, w = [mpf(x) for x in light[:3]], mpf(light[3])
    eye, points = [mpf(x) for x in eye], [[mpf(x) for x in p] for p in points]
    if w == 0:
        l = [x / sqrt(dot(l, l)) for x in l]
    clip = lambda x, h: (lambda r: [r[0] / mpf(TAN), r[1] / mpf(TAN), -mpf(101) / 99 * r[2] - mpf(200) / 99 * h, -r[2]])(
        [a - h * e for a, e in zip(x, eye)])
    L = clip(l, w)
    centre = [sum(p[i] for p in points) / len(points) for i in range(3)]
    ray = l if w == 0 else [a - b for a, b in zip(l, centre)]
    ray = [x / sqrt(dot(ray, ray)) for x in ray]
    along = [v - r * dot([0, 0, -1], ray) for v, r in zip([0, 0, -1], ray)]
    if dot(along, along) < mpf(10) ** -40:
        along = [0, 1, 0]
    across = cross(along, ray)
    ratios = []
    for p in points:
        q = clip(p, mpf(1))
        c = q[3] - L[3] / dot(L[:3], L[:3]) * dot(L[:3], q[:3])
        assert c > 0
        d = [a - b for a, b in zip(p, centre if w == 0 else l)]
        ratios.append((dot(across, d) / c, dot(along, d) / c))
    window = [(min(r[i] for r in ratios), max(r[i] for r in ratios)) for i in (0, 1)]
    return [[2 * (r[i] - window[i][0]) / (window[i][1] - window[i][0]) - 1 for i in (0, 1)] for r in ratios]


EYE = [0.0, 1.7, 0.0]
last_u = lambda light, eye=EYE: psm(light, receivers(eye), eye)[-1][0]


def jump(a, b, eye_a=EYE, eye_b=EYE):
    points = receivers(EYE)
    return 512 * max(hypot(p[0] - q[0], p[1] - q[1]) for p, q in zip(psm(a, points, eye_a), psm(b, points, eye_b)))


for name, z in (('w = 0', 0.0), ('w = 1e-7', -1e-7), ('w = -1e-7', 1e-7)):
    say(13, name, 'u, PSM', last_u([0.1, 1, z, 0]))
JUMP = 'jump of the map, texels, PSM'
say(13, 'w = -1e-7 to 1e-7', JUMP, jump([0.1, 1, 1e-7, 0], [0.1, 1, -1e-7, 0]))
say(20, 'point at depth 1e-6 and -1e-6', JUMP, jump([6, 21.7, 1e-6, 1], [6, 21.7, -1e-6, 1]))
for depth in ('D3D depth', 'reversed depth'):
    say(34, depth, 'u, PSM in the symmetric cube', last_u([0.1, 1, -0.4, 0]))
for y, name in ((1, 'light through +Y'), (-1, 'light through -Y')):
    say(36, name, JUMP, max(jump([x, y, z, 0], [-x, y, -z, 0]) for x, z in ((1e-7, 0), (0, 1e-7), (1e-7, 1e-7))))
for distance, name in ((2000.0, '2,000 from the origin'), (6.4e6, '6,400,000 from the origin')):
    for how in ("u, PSM, positions around the scene's middle (as uploaded)", 'u, PSM, positions in world space'):
        say(40, name, how, last_u([0.1, 1, -0.4, 0], [0.0 + distance, 1.7 + 0.0, 0.0 + distance]))
sideways = lambda x: [x, 1.7, 0.0]
say(41, 'eye moved from x = -1e-6 to 1e-6, psmlab does not snap', JUMP,
    jump([0.1, 1, -0.4, 0], [0.1, 1, -0.4, 0], sideways(-1e-6), sideways(1e-6)))

# ---- fractions --------------------------------------------------------------------------------------------------------------
A = mpf(101) / 99
say(16, 'vanishing point (0.5, 0)', "w'' at (1, 1, 1), looking at the centre", 1 - (mpf(1) / 2 + A) / (mpf(1) / 4 + A * A))
say(18, 'light at the eye, image 1280 x 720', 'anisotropy = aspect', mpf(1280) / 720)
say(34, 'D3D depth', 'z / w of the infinity plane', f / (f - n))
say(34, 'reversed depth', 'z / w of the infinity plane', -n / (f - n))
for how in ('atan2', 'acos'):
    say(38, 'theta = 0.01 deg', f'theta by {how}, degrees', mpf(1) / 100)
ONES = ((17, 'f = infinity', 'z / w of a directional light: the far face'), (21, 'point 3 behind the eye, H shifted in front', 'w after the shift = n'),
        (35, 'zero-depth body, n = f', 'rho of LiSPSM, psmlab: nothing to warp'))
for key in ONES:
    say(*key, 1)
say(20, 'point at depth 1e-6 and -1e-6', 'difference of the signs of w', 2)
say(43, "caster inside the receivers' footprint", 'w by which a divided PSM divides, at the caster', -16)
for which in ('lower end of the range of those at 5, 6, 7', 'the same where they stay in an array of zeros'):
    say(39, '5 of 8 points rejected', which, 5)

if __name__ == '__main__':
    for (number, case, quantity), value in sorted(out.items()):
        print(number, case, quantity, mp.nstr(value, 30), sep=';')
