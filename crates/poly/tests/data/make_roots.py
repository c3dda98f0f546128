"""Writes roots.txt: polynomials with 64-bit coefficients and their roots to 17 digits.

The coefficients are 64-bit floats, taken exactly as they are printed. The roots are those of exactly these
coefficients, by an Ehrlich-Aberth iteration with 400 digits, and checked: the sum of the inclusion radii
n |p/p'| has to be below 1e-60 of each root's modulus. The condition number of a root is
sum |c_k| |z|^k / (|z| |p'(z)|).

Run: python3 make_roots.py > roots.txt   (needs mpmath)
"""

import random

import mpmath as mp

mp.mp.dps = 400


def hull(logs):
    """Upper convex hull of (k, log|c_k|)."""
    corners = []
    for k, height in enumerate(logs):
        if height is None:
            continue
        while len(corners) > 1:
            (k0, h0), (k1, h1) = corners[-2:]
            if (h1 - h0) * (k - k0) > (height - h0) * (k1 - k0):
                break
            corners.pop()
        corners.append((k, height))
    return corners


def roots(c):
    """Nonzero roots of the polynomial with ascending coefficients c, and their conditions."""
    while c and c[0] == 0:
        c = c[1:]
    c = [mp.mpmathify(v) for v in c]
    n = len(c) - 1
    logs = [mp.log(abs(v)) if v != 0 else None for v in c]
    corners = hull(logs)
    z = []
    for circle, ((k0, h0), (k1, h1)) in enumerate(zip(corners, corners[1:])):
        radius = mp.exp((h0 - h1) / (k1 - k0))
        for j in range(k1 - k0):
            z.append(radius * mp.expjpi(2 * mp.mpf(j) / (k1 - k0) + 2 * mp.mpf(circle) / n + 0.21))
    done = [False] * n
    for _ in range(3000):
        for i in range(n):
            if done[i]:
                continue
            p, d = horner(c, z[i])
            if p == 0:
                done[i] = True
                continue
            step = 1 / (d / p - sum(1 / (z[i] - z[j]) for j in range(n) if j != i))
            if abs(step) > abs(z[i]):
                step *= abs(z[i]) / abs(step)
            z[i] -= step
            done[i] = abs(step) < abs(z[i]) * mp.mpf(10) ** -150
        if all(done):
            break
    assert all(done), "no convergence"
    out = []
    for v in z:
        p, d = horner(c, v)
        assert n * abs(p) < mp.mpf(10) ** -60 * abs(v) * abs(d), (v, p, d)
        terms = sum(abs(a) * abs(v) ** k for k, a in enumerate(c))
        out.append((v, terms / (abs(v) * abs(d))))
    return sorted(out, key=lambda r: (mp.re(r[0]), mp.im(r[0])))


def horner(c, x):
    p = d = mp.mpf(0)
    for a in reversed(c):
        d = d * x + p
        p = p * x + a
    return p, d


def product(zeros):
    """Exact ascending coefficients of the monic product, rounded to 64-bit floats."""
    c = [mp.mpc(1)]
    for zero in zeros:
        zero = mp.mpmathify(zero)
        c = [a - zero * b for a, b in zip([mp.mpc(0)] + c, c + [mp.mpc(0)])]
    return [float(mp.re(a)) for a in c]


def case(name, c):
    print("case", name)
    if any(isinstance(v, complex) for v in c):
        print("complex", *(f"{complex(v).real!r} {complex(v).imag!r}" for v in c))
    else:
        print("real", *(repr(float(v)) for v in c))
    for value, condition in roots(c):
        re, im = mp.re(value), mp.im(value)
        tiny = abs(value) * mp.mpf(10) ** -60
        re = mp.mpf(0) if abs(re) < tiny else re
        im = mp.mpf(0) if abs(im) < tiny else im
        print("root", mp.nstr(re, 20), mp.nstr(im, 20), mp.nstr(condition, 4))


def reversed_(descending):
    return list(reversed(descending))


def chebyshev(n):
    a, b = [1], [0, 1]
    for _ in range(n - 1):
        a, b = b, [2 * x - y for x, y in zip([0] + b, a + [0, 0])]
    return b


def mandelbrot(levels):
    p = [1]
    for _ in range(levels):
        square = [0] * (2 * len(p) - 1)
        for i, x in enumerate(p):
            for k, y in enumerate(p):
                square[i + k] += x * y
        p = [1] + square
    return p


# The numerators of the transmissibilities' differences of a lateral aircraft model sampled at 10 Hz.
AIRCRAFT = {
    "as_printed_roll_rate": [0.6906440710552105, -4.05982359385132, 9.962354672244818, -13.062468527299336,
                             9.651879761575605, -3.8105190830713336, 0.6279326993463553],
    "as_printed_yaw_rate": [-0.033328348944732286, 0.19546128243380537, -0.4784430167887857, 0.6256435968153042,
                            -0.46095963230101994, 0.18142435333801096, -0.029798234532190666],
    "dimensional_roll_rate": [0.0071023935088666505, -0.031183364701710226, 0.050627304766488405, -0.0323830004342956,
                              -0.001300818599333803, 0.010543884425585653, -0.0034063989656010793],
    "dimensional_yaw_rate": [-6.86980100532964e-05, 0.0004890119551728636, -0.001322218111287984,
                             0.0017834418941104623, -0.0012738877450384559, 0.00045358139564895245,
                             -6.123135816052425e-05],
}

random.seed(20240229)
for name, c in AIRCRAFT.items():
    case("aircraft_" + name, reversed_(c))
case("wilkinson_10", product(range(1, 11)))
case("wilkinson_20", product(range(1, 21)))
case("wilkinson_20_geometric", product(mp.mpf(2) ** -k for k in range(1, 21)))
case("unity_100", [-1.0] + [0.0] * 99 + [1.0])
case("chebyshev_20", [float(v) for v in chebyshev(20)])
case("chebyshev_40", [float(v) for v in chebyshev(40)])
case("mandelbrot_31", [float(v) for v in mandelbrot(5)])
case("near_double", product([1, mp.mpf("1.000001"), 2, 3]))
case("near_triple", product([1, mp.mpf("1.001"), mp.mpf("0.999"), -2]))
case("conjugate_clusters", product(
    mp.mpc(a, s * b) for a, b in [(0.5, 0.8), (0.501, 0.8), (0.5, 0.801), (-0.3, 0.02)] for s in (1, -1)))
case("near_unit_circle", product(
    mp.mpf("0.999") * mp.expjpi(s * mp.mpf(k) / 10) for k in range(1, 10) for s in (1, -1)))
case("near_real_pair", product([mp.mpc(1, "1e-7"), mp.mpc(1, "-1e-7"), 1.5, -1]))
case("moduli_1e-100_to_1e100", [10.0 ** (-2.0 * (k - 10) ** 2 + 0.5 * ((7 * k) % 5)) for k in range(21) if abs(k - 10) <= 7])
case("moduli_1e-150_1e150", [1e150, 1.0, 3e-150])
case("coefficients_spread", [random.uniform(-1, 1) * 10.0 ** random.uniform(-100, 100) for _ in range(31)])
case("coefficients_spread_150", [random.uniform(-1, 1) * 10.0 ** random.uniform(-150, 150) for _ in range(21)])
case("coefficients_near_overflow", [1e300, -3e305, 2.5e307, 1e308, -1.5e308])
case("coefficients_near_underflow", [1e-300, -3e-295, 2.5e-290, 1e-292, -1.5e-299])
case("random_50", [random.gauss(0, 1) for _ in range(51)])
case("random_100", [random.gauss(0, 1) for _ in range(101)])
case("truncated_exponential_40", [float(1 / mp.factorial(k)) for k in range(41)])
case("vanishing_leading", [2.0, -3.0, 1.0, 1e-30, -1e-200])
case("complex_random_20", [complex(random.gauss(0, 1), random.gauss(0, 1)) for _ in range(21)])
case("complex_near_double", [complex(0.25, 1.0), complex(-1.0, -2.0000000001), complex(0.5, 1.25), complex(1.0, 0.0)])
