"""Recomputes reference.json: every number of the paper's examples, in exact or 60-digit arithmetic.

`python reference.py` (needs mpmath) prints the largest difference from the committed file; `--write` rewrites it.
Example 4.1 and 4.2 are done in rationals, the aircraft in 60 decimal digits; a value is rounded to double only
when it is written. Polynomials have their highest power first.
"""

import json
import pathlib
import sys
from fractions import Fraction

import mpmath as mp

mp.mp.dps = 60
HERE = pathlib.Path(__file__).resolve().parent
SAMPLE_PERIOD = mp.mpf(1) / 10


def characteristic(A):
    """Faddeev-LeVerrier: det(pI - A), and the matrices N_k of adj(pI - A) = sum N_k p^(n-1-k)."""
    n = len(A)
    one, zero = A[0][0] * 0 + 1, A[0][0] * 0
    N = [[one if i == j else zero for j in range(n)] for i in range(n)]
    delta, adjugate = [one], []
    for k in range(1, n + 1):
        adjugate.append(N)
        AN = [[sum((A[i][s] * N[s][j] for s in range(n)), zero) for j in range(n)] for i in range(n)]
        c = -sum((AN[i][i] for i in range(n)), zero) / k
        delta.append(c)
        N = [[AN[i][j] + (c if i == j else zero) for j in range(n)] for i in range(n)]
    return delta, adjugate


def gamma(adjugate, c, b):
    """c adj(pI - A) b, without direct feedthrough."""
    return [sum((c[i] * N[i][j] * b[j] for i in range(len(c)) for j in range(len(b))), 0 * N[0][0]) for N in adjugate]


def multiply(p, q):
    out = [0 * p[0]] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return out


def subtract(p, q):
    n = max(len(p), len(q))
    p, q = [0 * p[0]] * (n - len(p)) + p, [0 * q[0]] * (n - len(q)) + q
    return strip([a - b for a, b in zip(p, q)])


def strip(p):
    while len(p) > 1 and p[0] == 0:
        p = p[1:]
    return p


def det_delta(i1, o1, i2, o2):
    return subtract(multiply(i1, o2), multiply(o1, i2))


def roots(p):
    as_mp = [mp.mpf(c.numerator) / c.denominator if isinstance(c, Fraction) else mp.mpf(c) for c in strip(p)]
    return [pair(z) for z in mp.polyroots(as_mp, maxsteps=500, extraprec=600)]


def pair(z):
    z = mp.mpc(z)
    flush = lambda x: 0.0 if abs(x) < mp.mpf(10) ** -40 else float(x)
    return [flush(z.real), flush(z.imag)]


def example_4_1():
    A = [[1, 1, 1], [0, 2, -1], [0, 1, 1]]
    c_i, c_o, b1, b2 = [1, 2, -1], [-1, 3, -2], [0, 1, 0], [0, 1, -1]
    delta, N = characteristic([[Fraction(x) for x in row] for row in A])
    g = {"gamma_i1": gamma(N, c_i, b1), "gamma_o1": gamma(N, c_o, b1), "gamma_i2": gamma(N, c_i, b2), "gamma_o2": gamma(N, c_o, b2)}
    det = det_delta(*g.values())
    whole = lambda p: [int(x) for x in p]
    return {"delta": whole(delta), **{k: whole(strip(v)) for k, v in g.items()}, "det_Delta": whole(det), "spec_A": roots(delta), "mroots_det_Delta": roots(det)}


def example_4_2():
    F = Fraction
    A = [[F(-7, 10), F(23, 100), F(239, 1000), F(546, 10000)], [F(1), F(0), F(0), F(0)], [F(0), F(1), F(0), F(0)], [F(0), F(0), F(1), F(0)]]
    B = [[1, 0], [1, 0], [4, 1], [0, 1]]
    C = [[1, 2, 3, 0], [8, 1, 1, 0], [1, 3, 1, 6]]
    delta, N = characteristic(A)
    g = {f"y{o + 1}_u{j + 1}": strip(gamma(N, C[o], [row[j] for row in B])) for o in range(3) for j in range(2)}
    out = {"gamma": {k: [str(x) for x in v] for k, v in g.items()}}
    for o in (2, 3):
        # T_{o,1|1} - T_{o,1|2}: numerator over the product of the two denominators.
        numerator = subtract(multiply(g[f"y{o}_u1"], g["y1_u2"]), multiply(g[f"y{o}_u2"], g["y1_u1"]))
        out[f"numerator_T{o}1_difference"] = [str(x) for x in numerator]
        out[f"roots_T{o}1_difference"] = roots(numerator)
    out["spec_A"] = roots(delta)
    return out


def aircraft(dimensional):
    m = mp.mpf
    U0, Ixx, Izz, Ixz = m(400), m(27915), m(47085), m(450)
    den = Ixx * Izz - Ixz**2
    G = mp.matrix([[1, 0, 0, 0], [0, Ixx * Izz / den, Ixz * Izz / den, 0], [0, Ixz * Ixx / den, Ixx * Izz / den, 0], [0, 0, 0, 1]])
    A = G * mp.matrix([[m("-55.4022") / U0, 0, (m("0.7689") - U0) / U0, m("32.174") / U0], [m("-4.1845"), m("-0.4365"), m("0.1571"), 0], [m("2.8643"), m("0.0046"), m("-0.1148"), 0], [0, 1, 0, 0]])
    B = G * mp.matrix([[0, m("10.4733") / (U0 if dimensional else 1)], [m("6.7714"), m("0.6543")], [m("-0.3879"), m("-1.6847")], [0, 0]])
    block = mp.zeros(6)
    block[:4, :4], block[:4, 4:] = A, B
    E = mp.expm(block * SAMPLE_PERIOD, method="taylor")
    Ad, Bd = E[:4, :4], E[:4, 4:]
    rows = lambda M: [[float(M[i, j]) for j in range(M.cols)] for i in range(M.rows)]
    delta, N = characteristic([[Ad[i, j] for j in range(4)] for i in range(4)])
    out = {"A": rows(A), "B": rows(B), "Ad": rows(Ad), "Bd": rows(Bd), "delta": [float(x) for x in delta], "spec_Ad": roots(delta)}
    sensors, surfaces, g = ("sideslip", "roll_rate", "yaw_rate"), ("aileron", "rudder"), {}
    for j, surface in enumerate(surfaces):
        for i, sensor in enumerate(sensors):
            p = gamma(N, [mp.mpf(i == k) for k in range(4)], [Bd[k, j] for k in range(4)])
            g[sensor, surface] = p
            out[f"gamma_{sensor}_{surface}"], out[f"zeros_{sensor}_{surface}"] = [float(x) for x in p], roots(p)
    for sensor in sensors[1:]:
        det = det_delta(g["sideslip", "aileron"], g[sensor, "aileron"], g["sideslip", "rudder"], g[sensor, "rudder"])
        out[f"det_Delta_sideslip_{sensor}"], out[f"mroots_det_Delta_sideslip_{sensor}"] = [float(x) for x in det], roots(det)
    continuous, _ = characteristic([[A[i, j] for j in range(4)] for i in range(4)])
    return roots(continuous), out


def difference(a, b, place="", is_root_list=False):
    """Largest relative difference of two parsed files; lists of roots are compared as sets."""
    if isinstance(a, dict):
        assert a.keys() == b.keys(), (place, a.keys() ^ b.keys())
        return max(difference(a[k], b[k], f"{place}/{k}", "roots" in k or "spec" in k or "zeros" in k) for k in a)
    if is_root_list:
        key = lambda z: (round(z[0], 9), round(z[1], 9))
        a, b = sorted(a, key=key), sorted(b, key=key)
    if isinstance(a, list):
        assert len(a) == len(b), place
        return max(difference(x, y, place) for x, y in zip(a, b))
    if isinstance(a, str):
        assert Fraction(a) == Fraction(b), (place, a, b)
        return 0.0
    return abs(a - b) / max(1.0, abs(b))


if __name__ == "__main__":
    spectrum, printed = aircraft(False)
    made = {"example_4_1": example_4_1(), "example_4_2": example_4_2(), "aircraft": {"spec_A": spectrum, "as_printed": printed, "dimensional": aircraft(True)[1]}}
    made = json.loads(json.dumps(made))
    if "--write" in sys.argv:
        (HERE / "reference.json").write_text(json.dumps(made, indent=1) + "\n")
    else:
        worst = difference(made, json.loads((HERE / "reference.json").read_text()))
        print(f"largest difference from reference.json: {worst:.1e}")
        sys.exit(worst > 1e-15)
