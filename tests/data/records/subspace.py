"""Oracle of the signal-subspace intersection, in numpy: `python subspace.py` compares with subspace.json, `--write` rewrites it.

For each pair of noisy records, given block rows and given noise levels: A from the n directions that the noise directions of both records
annihilate (mL - (L + n) eigenvectors of each covariance, as for sensors that may read the excitation directly), and the eigenvalues log(z)/T.
The covariances are formed from the block-Hankel matrices as they stand, the eigenvectors are LAPACK's.
"""
import json, pathlib, sys
import numpy as np

HERE, T, ORDER = pathlib.Path(__file__).resolve().parent, 0.1, 4
LEVELS = {"white_snr100": (40, [0.0286, 0.0720, 0.0553]), "white_snr10": (40, [0.279, 0.732, 0.543]), "multistep_snr100": (20, [0.0252, 0.0667, 0.0434])}


def noise_directions(samples, levels, rows, centred):
    scaled = samples / levels
    h = np.concatenate([scaled[i:i + len(scaled) - rows + 1].T for i in range(rows)])
    if centred:
        h = h - h.mean(1, keepdims=True)
    _, vectors = np.linalg.eigh(h @ h.T / h.shape[1])
    return vectors[:, :len(levels) * rows - (rows + ORDER)]


def intersect(pair, levels, rows, centred):
    noise = [noise_directions(samples, levels, rows, centred) for samples in pair]
    values, vectors = np.linalg.eigh(sum(n @ n.T for n in noise))
    o, m = vectors[:, :ORDER], len(levels)
    a = np.linalg.lstsq(o[:-m], o[m:], rcond=None)[0]
    s = sorted(np.log(np.linalg.eigvals(a) + 0j) / T, key=lambda s: (s.real, s.imag))
    return [[z.real, z.imag] for z in s], values[:8].tolist()


def main():
    found = {}
    for name, (rows, levels) in LEVELS.items():
        pair = [np.loadtxt(HERE / f"{name}_{surface}.csv", delimiter=",", skiprows=1)[:, 1:] for surface in ("aileron", "rudder")]
        found[name] = {"block_rows": rows, "noise_levels": levels}
        for key, centred in (("rows", True), ("none", False)):
            poles, values = intersect(pair, np.array(levels), rows, centred)
            found[name][key] = {"eigenvalues": poles, "order_eigenvalues": values}
    file = HERE / "subspace.json"
    if "--write" in sys.argv:
        file.write_text(json.dumps(found, indent=1) + "\n")
    committed = json.loads(file.read_text())
    worst = max(
        abs(complex(*p) - complex(*q)) / abs(complex(*q))
        for name in found for key in ("rows", "none")
        for p, q in zip(found[name][key]["eigenvalues"], committed[name][key]["eigenvalues"]))
    print(f"largest relative difference of an eigenvalue: {worst:.1e}")
    sys.exit(worst > 1e-7)


main()
