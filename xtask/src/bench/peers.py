"""One measurement of a peer, printed as one line of JSON.

    peers.py versions
    peers.py lstsq|gelsy|gram SAMPLES L R D RUNS INPUT OUTPUT
    peers.py ib01ad SAMPLES BLOCK_ROWS ALGORITHM RUNS CHANNEL..
    peers.py ib01md-blocks SAMPLES BLOCK_ROWS ALGORITHM RUNS CHANNEL..
    peers.py regression|output-error RUNS FLIGHT

INPUT, OUTPUT and CHANNEL are files of raw little-endian doubles, FLIGHT is a packed CSV of beta, p, r and surfaces. Only the solver is timed: the regressors are built before. The answer is
{"seconds": [..], "theta": [..]} or {"unavailable": "why"}; the caller limits the threads by the environment.
"""

import json
import sys
import time


def read(file, samples):
    import numpy

    signal = numpy.fromfile(file, dtype="<f8", count=samples)
    if len(signal) != samples:
        raise ValueError(f"{file} holds {len(signal)} samples, {samples} are needed")
    return signal


def regressors(samples, l, r, d, y_i, y_o):
    """-y_o(k+i) for i = 1 .. l-1, y_i(k-i) for i = -d .. r, and the target y_o(k+l); column-major, as LAPACK wants it."""
    import numpy

    first, last = r, samples - max(l, d)
    a = numpy.empty((last - first, l - 1 + r + d + 1), order="F")
    for column, i in enumerate(range(1, l)):
        a[:, column] = -y_o[first + i : last + i]
    for column, i in enumerate(range(-d, r + 1), start=l - 1):
        a[:, column] = y_i[first - i : last - i]
    return a, y_o[first + l : last + l].copy()


def lstsq(a, b):
    import numpy

    return numpy.linalg.lstsq(a, b, rcond=None)[0]


def gelsy(a, b):
    import scipy.linalg

    return scipy.linalg.lstsq(a, b, lapack_driver="gelsy", check_finite=False)[0]


def gram(a, b):
    import scipy.linalg

    return scipy.linalg.cho_solve(scipy.linalg.cho_factor(a.T @ a), a.T @ b)


def timed(runs, work):
    answer, seconds = None, []
    for _ in range(runs + 1):
        start = time.perf_counter()
        answer = work()
        seconds.append(time.perf_counter() - start)
    return answer, seconds[1:]  # the first one warms up


def least_squares(solve, samples, l, r, d, runs, y_i, y_o):
    samples, l, r, d = int(samples), int(l), int(r), int(d)
    a, b = regressors(samples, l, r, d, read(y_i, samples), read(y_o, samples))
    theta, seconds = timed(int(runs), lambda: solve(a, b))
    return {"seconds": seconds, "theta": [float(x) for x in theta]}


def signals(samples, channels):
    """Outputs in columns, and no inputs."""
    import numpy

    y = numpy.asfortranarray(numpy.stack([read(file, samples) for file in channels], axis=1))
    return numpy.zeros((samples, 0), order="F"), y


def ib01ad(samples, block_rows, algorithm, runs, *channels):
    """MOESP's preprocessing and order estimation, with the whole record in one call."""
    import ctrlsys

    u, y = signals(int(samples), channels)
    nobr = int(block_rows) // 2  # SLICOT's Hankel matrix has 2 * nobr block rows
    work = lambda: ctrlsys.ib01ad("M", algorithm, "N", "O", "N", "N", nobr, 0, len(channels), u, y, 0.0, -1.0)
    answer, seconds = timed(int(runs), work)
    return judged(seconds, *answer[-2:])


def ib01md_blocks(samples, block_rows, algorithm, runs, *channels):
    """The triangular factor alone, with the record in blocks that stay in the cache; no row reaches across their seams."""
    import ctrlsys
    import numpy

    size = 20_000
    samples, nobr, outputs = int(samples), int(block_rows) // 2, len(channels)
    u, y = signals(samples, channels)
    parts = [(u[k : k + size], numpy.asfortranarray(y[k : k + size])) for k in range(0, samples, size)]

    def work():
        state = ()
        for index, part in enumerate(parts):
            batch = "F" if index == 0 else "L" if index == len(parts) - 1 else "I"
            *state, warning, info = ctrlsys.ib01md("M", algorithm, batch, "N", nobr, 0, outputs, *part, *state)
            if info != 0:
                break
        return warning, info

    answer, seconds = timed(int(runs), work)
    return judged(seconds, *answer)


def judged(seconds, warning, info):
    if info != 0:
        raise ValueError(f"SLICOT returns info = {info}")
    return {"seconds": seconds, "warning": int(warning)}


def flight(file):
    """Sensors beta, p, r and surfaces of a record of a simulator; the mean taken out."""
    import csv
    import gzip

    import numpy

    with gzip.open(file, "rt") as source:
        rows = list(csv.reader(source))
    names, data = rows[0], numpy.array(rows[1:], dtype=float)
    data -= data.mean(axis=0)
    of = lambda wanted: data[:, [names.index(name) for name in wanted]]
    return of(["beta", "p", "r"]), of(["d_aileron", "d_rudder"]), float(rows[2][0]) - float(rows[1][0])


def roll_and_dutch_roll(discrete, period):
    """The real eigenvalue with the largest |s|, and the pair with the largest |s|: real part, real and imaginary part."""
    import numpy

    s = numpy.log(numpy.linalg.eigvals(discrete) + 0j) / period
    real = [value.real for value in s if abs(value.imag) < 1e-9]
    pairs = [value for value in s if value.imag > 1e-9]
    if not real or not pairs:
        raise ValueError("no roll or no Dutch roll among the eigenvalues")
    pair = max(pairs, key=abs)
    return [min(real), pair.real, pair.imag]


def regression(runs, file):
    """Equation error: the next sample on states and inputs, with the bank angle from the roll rate."""
    import numpy

    y, u, period = flight(file)

    def work():
        bank = numpy.cumsum(y[:, 1]) * period
        state = numpy.column_stack([y, bank - bank.mean()])
        columns = numpy.column_stack([state[:-1], u[:-1]])
        solution = numpy.linalg.lstsq(columns, state[1:], rcond=None)[0]
        return roll_and_dutch_roll(solution[:4].T, period)

    theta, seconds = timed(int(runs), work)
    return {"seconds": seconds, "theta": theta}


def output_error(runs, file):
    """Output error in the time domain: the lateral equations, all derivatives and the initial state, by Levenberg-Marquardt."""
    import numpy
    import scipy.linalg
    import scipy.optimize
    import scipy.signal

    y, u, period = flight(file)
    scale = y.std(axis=0)

    def discrete(theta):
        a = numpy.zeros((4, 4))
        a[0], a[1, :3], a[2, :3], a[3, 1], a[3, 2] = theta[:4], theta[4:7], theta[7:10], 1.0, theta[10]
        b = numpy.zeros((4, 2))
        b[:3] = theta[11:17].reshape(3, 2)
        step = scipy.linalg.expm(numpy.block([[a, b], [numpy.zeros((2, 6))]]) * period)
        return step[:4, :4], step[:4, 4:]

    def residuals(theta):
        a, b = discrete(theta)
        system = scipy.signal.dlti(a, b, numpy.eye(3, 4), numpy.zeros((3, 2)), dt=period)
        found = scipy.signal.dlsim(system, u, x0=theta[17:21])[1]
        error = ((found - y) / scale).ravel()
        return numpy.where(numpy.isfinite(error), error, 1e6).clip(-1e6, 1e6)

    def work():
        start = numpy.zeros(21)
        start[:11] = [-0.2, 0.05, -1.0, 0.08, -10.0, -2.0, 0.5, 3.0, 0.0, -0.5, 0.05]
        start[11:17] = [0.0, 0.0, 5.0, 0.5, 0.0, -2.0]
        found = scipy.optimize.least_squares(residuals, start, method="lm", x_scale="jac", max_nfev=2000)
        return roll_and_dutch_roll(discrete(found.x)[0], period)

    theta, seconds = timed(int(runs), work)
    return {"seconds": seconds, "theta": theta}


def versions():
    found = {"Python": sys.version.split()[0]}
    for name in ["numpy", "scipy", "ctrlsys"]:
        try:
            found[name] = __import__(name).__version__
        except ImportError:
            pass
    try:
        import numpy

        blas = numpy.show_config(mode="dicts")["Build Dependencies"]["blas"]
        found[blas["name"]] = blas["version"]
    except (ImportError, KeyError, TypeError):
        pass
    return {"versions": found}


LEAST_SQUARES = {"lstsq": lstsq, "gelsy": gelsy, "gram": gram}
SUBSPACE = {"ib01ad": ib01ad, "ib01md-blocks": ib01md_blocks}
RECORDED = {"regression": regression, "output-error": output_error}


def main(task, *arguments):
    if task == "versions":
        return versions()
    if task in SUBSPACE:
        return SUBSPACE[task](*arguments)
    if task in RECORDED:
        return RECORDED[task](*arguments)
    return least_squares(LEAST_SQUARES[task], *arguments)


if __name__ == "__main__":
    try:
        result = main(*sys.argv[1:])
    except (ImportError, MemoryError, ValueError) as error:
        result = {"unavailable": f"{type(error).__name__}: {error}"}
    print(json.dumps(result))
