"""Makes oracle.json: systems with their sampled matrices, poles, zeros, polynomials and responses in 60 digits.

`python oracle.py` (needs mpmath) prints the largest difference from the committed file; `--write` rewrites it.
Every input matrix is taken as the exact value of its doubles; a result is rounded to double only when it is
written. Polynomials have their lowest power first.
"""

import json
import pathlib
import random
import sys

import mpmath as mp

mp.mp.dps = 60
HERE = pathlib.Path(__file__).resolve().parent


def systems():
    """Name -> A, B, C, D, sample period in s."""
    reference = json.loads((HERE / "aircraft.json").read_text())["as_printed"]
    aircraft, controls = reference["A"], reference["B"]
    sensors = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]
    no_feedthrough = [[0.0, 0.0]] * 3
    yield "aircraft", aircraft, controls, sensors, no_feedthrough, 0.1

    # The same aircraft in units that differ by up to 2^40: a similarity that no double rounds.
    units = [2.0**20, 1.0, 2.0**-20, 2.0**7]
    a = [[aircraft[i][j] * units[j] / units[i] for j in range(4)] for i in range(4)]
    b = [[controls[i][j] / units[i] for j in range(2)] for i in range(4)]
    c = [[sensors[i][j] * units[j] for j in range(4)] for i in range(3)]
    yield "aircraft_in_odd_units", a, b, c, no_feedthrough, 0.1

    # A servo of 400 1/s, a slow mode of 1e-3 1/s, and coupling between them.
    a = [[-400.0, 390.0, 0.0], [0.5, -3.0, 2.0], [0.0, 0.001, -0.001]]
    yield "stiff", a, [[400.0], [0.0], [0.25]], [[0.0, 1.0, 1.0]], [[0.0]], 0.05

    # Cart and pendulum with an integrator of the position: a chain of integrators and an unstable pole.
    a = [
        [0.0, 1.0, 0.0, 0.0, 0.0],
        [0.0, -0.1, -2.5, 0.0, 0.0],
        [0.0, 0.0, 0.0, 1.0, 0.0],
        [0.0, 0.2, 24.0, 0.0, 0.0],
        [1.0, 0.0, 0.0, 0.0, 0.0],
    ]
    b = [[0.0], [1.0], [0.0], [-2.0], [0.0]]
    yield "cart_and_pendulum", a, b, [[1.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0, 0.0]], [[0.0], [0.0]], 0.02

    # A lightly damped structure: three modes with damping ratios of 1e-6 to 1e-3, the last two close together.
    a = [[0.0] * 6 for _ in range(6)]
    for k, (omega, zeta) in enumerate([(2.0, 1e-6), (9.0, 1e-4), (9.001, 1e-3)]):
        a[2 * k][2 * k + 1] = 1.0
        a[2 * k + 1][2 * k] = -omega * omega
        a[2 * k + 1][2 * k + 1] = -2 * zeta * omega
    b = [[0.0], [1.0], [0.0], [1.0], [0.0], [-1.0]]
    yield "light_damping", a, b, [[1.0, 0.0, 1.0, 0.0, 1.0, 0.0]], [[0.125]], 0.1

    # Far from normal: large couplings above the diagonal.
    a = [[-1.0, 1e3, 1e5], [0.0, -2.0, 1e4], [0.0, 0.0, -3.0]]
    yield "nonnormal", a, [[0.0], [0.0], [1.0]], [[1.0, 0.0, 0.0]], [[0.0]], 0.25

    # Eight states drawn at random, two inputs, two outputs, full feedthrough.
    draw = random.Random(20240607)
    rounded = lambda scale: round(draw.gauss(0.0, scale), 3)
    a = [[rounded(0.5) - (1.0 if i == j else 0.0) for j in range(8)] for i in range(8)]
    b = [[rounded(1.0) for _ in range(2)] for _ in range(8)]
    c = [[rounded(1.0) for _ in range(8)] for _ in range(2)]
    d = [[rounded(1.0) for _ in range(2)] for _ in range(2)]
    yield "random_8", a, b, c, d, 0.5


def characteristic(a):
    """Faddeev-LeVerrier: det(pI - A) ascending, and the coefficients of adj(pI - A), ascending."""
    n = a.rows
    power, delta, adjugate = mp.eye(n), [mp.mpf(1)], []
    for k in range(1, n + 1):
        adjugate.append(power)
        product = a * power
        c = -sum(product[i, i] for i in range(n)) / k
        delta.append(c)
        power = product + c * mp.eye(n)
    return delta[::-1], adjugate[::-1]


def roots(ascending):
    """Roots as companion eigenvalues in 60 digits; vanishing leading coefficients are dropped."""
    p = list(ascending)
    scale = max((abs(x) for x in p), default=0)
    while p and abs(p[-1]) <= scale * mp.mpf(10) ** -50:
        p.pop()
    if len(p) < 2:
        return []
    n = len(p) - 1
    companion = mp.zeros(n)
    for i in range(n):
        companion[0, i] = -p[n - 1 - i] / p[n]
        if i:
            companion[i, i - 1] = 1
    return eigenvalues(companion)


def eigenvalues(a):
    values = mp.eig(a, left=False, right=False)
    # A defective eigenvalue at zero splits: what is left of 60 digits over its multiplicity stands for zero.
    clean = [mp.mpc(*(0 if abs(x) < mp.mpf(10) ** -20 else x for x in (z.real, z.imag))) for z in values]
    return sorted(clean, key=lambda z: (float(z.real), abs(float(z.imag)), -float(z.imag)))


def zero_order_hold(a, b, period):
    n, m = a.rows, b.cols
    block = mp.zeros(n + m)
    for i in range(n):
        for j in range(n):
            block[i, j] = a[i, j] * period
        for j in range(m):
            block[i, n + j] = b[i, j] * period
    e = mp.expm(block, method="taylor")
    return e[:n, :n], e[:n, n:]


def determinant_zeros(a, b, c, d):
    """Zeros of a square system: det [xI - A, -B; C, D] interpolated at integers, and its roots."""
    n, m = a.rows, b.cols
    points = range(-(n // 2), n - n // 2 + 1)
    values = []
    for x in points:
        matrix = mp.zeros(n + m)
        for i in range(n + m):
            for j in range(n + m):
                if i < n and j < n:
                    matrix[i, j] = (x if i == j else 0) - a[i, j]
                elif i < n:
                    matrix[i, j] = -b[i, j - n]
                elif j < n:
                    matrix[i, j] = c[i - n, j]
                else:
                    matrix[i, j] = d[i - n, j - n]
        values.append(mp.det(matrix))
    vandermonde = mp.matrix([[mp.mpf(x) ** k for k in range(n + 1)] for x in points])
    return roots(list(mp.lu_solve(vandermonde, mp.matrix(values))))


def solve(name, a, b, c, d, period):
    A, B, C, D = (mp.matrix(x) for x in (a, b, c, d))
    n, m, p = A.rows, B.cols, C.rows
    ad, bd = zero_order_hold(A, B, mp.mpf(period))
    delta, adjugate = characteristic(A)

    def gamma(i, j):
        through = [sum(C[i, r] * N[r, s] * B[s, j] for r in range(n) for s in range(n)) for N in adjugate] + [0]
        return [x + D[i, j] * y for x, y in zip(through, delta)]

    gammas = [[gamma(i, j) for j in range(m)] for i in range(p)]
    frequencies = [0.013, 0.7, 3.0, 40.0]
    response = []
    for omega in frequencies:
        columns = [mp.lu_solve(mp.mpc(0, omega) * mp.eye(n) - A, B[:, j]) for j in range(m)]
        response.append([[sum(C[i, k] * columns[j][k] for k in range(n)) + D[i, j] for j in range(m)] for i in range(p)])
    return {
        "A": a, "B": b, "C": c, "D": d, "period_s": period,
        "Ad": rows(ad), "Bd": rows(bd),
        "poles": pairs(eigenvalues(A)), "poles_z": pairs(eigenvalues(ad)),
        "delta": numbers(delta), "gamma": [[numbers(g) for g in row] for row in gammas],
        "zeros": [[pairs(roots(g)) for g in row] for row in gammas],
        # Of the square part made of the first outputs and inputs.
        "square": min(m, p),
        "square_zeros": pairs(determinant_zeros(A, B[:, : min(m, p)], C[: min(m, p), :], D[: min(m, p), : min(m, p)])),
        "frequencies_rad_s": frequencies,
        "response": [[[[float(mp.re(x)), float(mp.im(x))] for x in row] for row in g] for g in response],
    }


def numbers(values):
    size = max(abs(x) for x in values)
    return [0.0 if abs(x) < size * mp.mpf(10) ** -45 else float(x) for x in values]


def rows(matrix):
    return [[float(matrix[i, j]) for j in range(matrix.cols)] for i in range(matrix.rows)]


def pairs(values):
    return [[float(z.real), float(z.imag)] for z in values]


def differences(x, y):
    if isinstance(x, dict):
        return max((differences(x[k], y[k]) for k in x), default=0.0)
    if isinstance(x, list):
        assert len(x) == len(y)
        return max((differences(u, v) for u, v in zip(x, y)), default=0.0)
    return abs(x - y)


if __name__ == "__main__":
    result = {system[0]: solve(*system) for system in systems()}
    path = HERE / "oracle.json"
    if "--write" in sys.argv:
        lines = [f'"{k}": {json.dumps(v)}' for k, v in result.items()]
        path.write_text("{\n" + ",\n".join(lines) + "\n}\n")
    else:
        print(differences(result, json.loads(path.read_text())))
