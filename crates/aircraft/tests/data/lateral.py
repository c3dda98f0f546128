"""Makes lateral.json: aircraft with and without what brings further modes, and which eigenvalue is which mode.

`python lateral.py [truth.json]` (needs mpmath). With the truth of the simulator records it takes the six matrices from there, otherwise from
the lateral.json beside this file. States are sideslip, roll rate, yaw rate, bank angle, and what is added; rad, s.

Which eigenvalue is which is not asked of the shapes that the Rust code goes by. The mode of an added state is the one in which that state takes
part most (participation factor: product of its components in the left and the right eigenvector). Of what remains, the pair is the Dutch roll, of two
real modes the faster decaying one is the roll subsidence, a single one the spiral.
"""

import json
import pathlib
import sys

import mpmath as mp

HERE = pathlib.Path(__file__).resolve().parent
MATLAB = 'Boeing 747 in cruise, from "Yaw Damper Design for a 747 Jet Aircraft", Control System Toolbox (MathWorks)'
VFW = "VFW 614, as printed in github.com/hnamtang/flight-control, homework_1/src/model_lat.m"
JSBSIM = "JSBSim 1.3.3, {}, linearised by central differences at trim"
PAPER = "the paper's aircraft (aircraft.json, dimensional side force)"

# Gain from yaw rate to rudder, s: adds about 0.2 to the damping ratio of the Dutch roll, 0.05 for the A-4, whose own damper is on.
GAIN = {"paper": 0.42, "787-8": 0.86, "J3Cub": 0.16, "MD11": 3.62, "A4": 0.2, "Concorde": 0.70, "737": 1.06, "747": 1.14, "VFW614": 0.48}

# The 737 of the simulator as it is: a washed-out yaw damper and servos of 15 and 20 rad/s, seven states.
SERVOS = "yaw damper, washout and two servos of the simulator"
WHOLE = []


def reordered(A, B, order):
    return [[A[i][j] for j in order] for i in order], [B[i] for i in order]


def aircraft():
    paper = json.loads((HERE / "aircraft.json").read_text())["dimensional"]
    yield "paper", PAPER, paper["A"], paper["B"]
    committed = HERE / "lateral.json"
    if len(sys.argv) > 1:
        truth = json.loads(pathlib.Path(sys.argv[1]).read_text())["aircraft"]
        for name in ["787-8", "J3Cub", "MD11", "A4", "Concorde", "737"]:
            if name == "737":
                WHOLE.append(truth[name]["A"])
            yield name, JSBSIM.format(name), truth[name]["A4"], truth[name]["B4"]
    else:
        for one in json.loads(committed.read_text())["aircraft"]:
            if one["source"].startswith("JSBSim"):
                WHOLE.extend(variant["A"] for variant in one["variants"] if variant["what"] == SERVOS)
                yield one["name"], one["source"], one["A"], one["B"]
    # States beta, r, p, phi and inputs rudder, aileron.
    A = [[-.0558, -.9968, .0802, .0415], [.598, -.115, -.0318, 0], [-3.05, .388, -.4650, 0], [0, .0805, 1, 0]]
    B = [[0, .00729], [.00775, -.475], [.143, .153], [0, 0]]
    yield "747", MATLAB, *reordered(A, B, [0, 2, 1, 3])
    # States r, beta, p, phi and inputs aileron, rudder.
    A = [[-.4956, 1.9243, -.1206, 0], [-.9795, -.193, .0963, .1055], [2.107, -5.5049, -3.3388, 0], [0, 0, 1, 0]]
    B = [[-.4515, -1.318], [0, .0362], [-9.498, 1.9929], [0, 0]]
    yield "VFW614", VFW, *reordered(A, B, [1, 2, 0, 3])


def damped(A, rudder, gain):
    """Rudder = gain r, with the sign that damps."""
    gain = -gain if rudder[2] > 0 else gain
    return [[a + gain * b * (j == 2) for j, a in enumerate(row)] for row, b in zip(A, rudder)]


def bordered(A, column, row, corner):
    return [list(a) + [c] for a, c in zip(A, column)] + [list(row) + [corner]]


def variants(name, A, B):
    aileron, rudder = [row[0] for row in B], [row[1] for row in B]
    gain, sign = GAIN[name], -1 if rudder[2] > 0 else 1
    yield "airframe", A
    yield "yaw damper", damped(A, rudder, gain)
    if name == "747":
        yield "yaw damper of 0.6 s", damped(A, rudder, 0.6)
    if name == "737":
        yield SERVOS, WHOLE[0]
    for time in [1, 2, 4]:
        # Rudder = gain (r - w), w' = (r - w) / time.
        closed = damped(A, rudder, gain)
        yield f"yaw damper with a washout of {time} s", bordered(closed, [-sign * gain * b for b in rudder], [0, 0, 1 / time, 0], -1 / time)
    yield "heading", bordered(A, [0] * 4, [0, 0, 1, 0], 0)
    yield "yaw damper, heading", bordered(damped(A, rudder, gain), [0] * 4, [0, 0, 1, 0], 0)
    for rate in [5, 10, 20]:
        # Rudder' = rate (gain r - rudder).
        yield f"yaw damper with an actuator of {rate} rad/s", bordered(A, rudder, [0, 0, sign * rate * gain, 0], -rate)
    for rate in [5, 10, 20]:
        yield f"aileron actuator of {rate} rad/s", bordered(A, aileron, [0] * 4, -rate)
    # A slow state between bank angle and yawing moment.
    yield "slow coupling", bordered(A, [0, 0, 0.02, 0], [0, 0, 0, 0.02], -0.1)


def modes(A):
    E, left, right = mp.eig(mp.matrix(A), left=True, right=True)
    n, found = len(A), []
    for k in range(n):
        product = sum(left[k, i] * right[i, k] for i in range(n))
        parts = [float(abs(left[k, i] * right[i, k] / product)) for i in range(4, n)]
        value = complex(E[k])
        if abs(value.imag) < 1e-9:
            found.append((parts, complex(value.real)))
        elif value.imag > 0:
            found.append((parts, value))
    return found


def expected(A):
    found = modes(A)
    for added in range(len(A) - 4):
        found.remove(max(found, key=lambda mode: mode[0][added]))
    pairs, real = [z for _, z in found if z.imag], sorted(z.real for _, z in found if not z.imag)
    assert len(pairs) == 1 and len(real) in (1, 2), found
    return {"dutch_roll": [pairs[0].real, pairs[0].imag], "roll": real[0] if len(real) == 2 else None, "spiral": real[-1]}


def main():
    # A line for each variant.
    blocks = []
    for name, source, A, B in list(aircraft()):
        lines = [json.dumps({"what": what, **expected(M), "A": M}) for what, M in variants(name, A, B)]
        head = json.dumps({"name": name, "source": source, "A": A, "B": B})[:-1]
        blocks.append(head + ', "variants": [\n  ' + ",\n  ".join(lines) + "\n ]}")
    (HERE / "lateral.json").write_text('{"aircraft": [\n ' + ",\n ".join(blocks) + "\n]}\n")


main()
