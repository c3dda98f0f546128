"""Exact least-squares solutions of the noise-free records, and the true parameters: the oracle of tests/it/noise_free.rs.

    python exact_least_squares.py          prints the largest difference from the committed file
    python exact_least_squares.py --write  rewrites exact_least_squares.json

Needs mpmath. The Gram matrices are exact (integers), the Cholesky solution has 80 digits and is rounded
to double at the end.
The true parameters follow from the numerators in reference.json: D(q) = q gamma_i(q) / lead, sum of h_i q^-i = q gamma_o(q) / lead.
"""
import csv, json, pathlib, sys
from fractions import Fraction
import mpmath as mp

mp.mp.dps = 80
HERE = pathlib.Path(__file__).resolve().parent
DATA = HERE.parents[3] / "tests" / "data"
ORDERS = (4, 25, 25)
SHIFT = 1100  # every double is an integer multiple of 2^-1074


def signal(path, name):
    with open(path) as file:
        return [int(Fraction(float(row[name])) * 2**SHIFT) for row in csv.DictReader(file)]


def exact(y_i, y_o):
    l, r, d = ORDERS
    steps = range(r, len(y_i) - max(l, d))
    rows = [[-y_o[k + i] for k in steps] for i in range(1, l)] + [[y_i[k - i] for k in steps] for i in range(-d, r + 1)]
    psi = [y_o[k + l] for k in steps]
    dot = lambda a, b: mp.mpf(sum(x * y for x, y in zip(a, b))) / mp.mpf(2) ** (2 * SHIFT)
    gram = mp.matrix(len(rows))
    for i, a in enumerate(rows):
        for j in range(i + 1):
            gram[i, j] = gram[j, i] = dot(a, rows[j])
    return mp.cholesky_solve(gram, mp.matrix([dot(a, psi) for a in rows]))


def truth(gamma_i, gamma_o):
    l, r, d = ORDERS
    theta = [0.0] * (l - 1 + d + r + 1)
    lead = gamma_i[0]
    theta[:3] = [c / lead for c in reversed(gamma_i[1:])]
    theta[l - 1 + d - 4 : l - 1 + d] = [c / lead for c in gamma_o]
    return theta


def main():
    aircraft = json.load(open(DATA / "reference.json"))["aircraft"]["as_printed"]
    answer = {}
    for surface in ("aileron", "rudder"):
        path = DATA / "records" / f"noise_free_{surface}.csv"
        for channel, name in (("p", "roll_rate"), ("r", "yaw_rate")):
            theta = exact(signal(path, "beta"), signal(path, channel))
            answer[f"{surface}_{channel}"] = {
                "exact": [float(x) for x in theta],
                "true": truth(aircraft[f"gamma_sideslip_{surface}"], aircraft[f"gamma_{name}_{surface}"]),
            }
    target = HERE / "exact_least_squares.json"
    if "--write" in sys.argv:
        target.write_text(json.dumps(answer, indent=1) + "\n")
    committed = json.loads(target.read_text())
    worst = max(abs(a - b) for k in answer for a, b in zip(answer[k]["exact"], committed[k]["exact"]))
    print("largest difference from the committed file:", worst)


main()
