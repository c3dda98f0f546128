"""Oracle of the maximum likelihood: a plain numpy/scipy version of both stages, run on the noisy records in records/.

`python likelihood.py` recomputes likelihood.json and prints the largest difference from the committed file;
`--write` rewrites it. Slow and plain on purpose: the Jacobian is by finite differences.

For each pair of records, with sensor offsets taken as zero and as free:
  noise_true        the noise levels that the simulation used
  start             A, B (one column per record), C from the signal subspaces, and the noise levels found with them
  known, estimated  the likelihood's poles with deviations and chi^2 per degree of freedom, noise levels known or as in `start`
"""
import json
import pathlib
import sys

import numpy as np

T = 0.1  # sample period in s
PAIRS = {"white_snr100": 40, "white_snr10": 40, "multistep_snr100": 20}  # block rows
SNR = {"white_snr100": 100, "white_snr10": 10, "multistep_snr100": 100}


def hankel(Y, L, centre):
    H = np.concatenate([Y[i:i + len(Y) - L + 1].T for i in range(L)], 0)
    return H - H.mean(1, keepdims=True) if centre else H


def noise_space(Y, sigma, L, n, offsets):
    """The mL-(L+n) directions that no trajectory excited by one input reaches."""
    H = hankel(Y / sigma, L, offsets)
    w, V = np.linalg.eigh(H @ H.T / H.shape[1])
    return V[:, :Y.shape[1] * L - (L + n)], H


def noise_levels(Ys, L, n, offsets, iterations=12):
    m = Ys[0].shape[1]
    sigma = 1e-2 * np.mean([Y.std(0) for Y in Ys], 0)
    for _ in range(iterations):
        M, v = np.zeros((m, m)), np.zeros(m)
        for Y in Ys:
            K, H = noise_space(Y, sigma, L, n, offsets)
            R = K.T @ (H @ H.T / H.shape[1]) @ K
            Ri = np.linalg.inv(R)
            Ms = [k.T @ k for k in (K.reshape(L, m, -1)[:, i] for i in range(m))]
            M += [[np.sum((Ri @ a) * (Ri @ b).T) for b in Ms] for a in Ms]
            v += [np.sum((Ri @ a) * (Ri @ R).T) for a in Ms]
        sigma = sigma * np.sqrt(np.maximum(np.linalg.solve(M, v), 1e-4))
    return sigma


def intersect(Ys, sigma, L, n, offsets):
    """A, B (one column per record), C in scaled sensor units."""
    m = Ys[0].shape[1]
    Ks = [noise_space(Y, sigma, L, n, offsets)[0] for Y in Ys]
    _, V = np.linalg.eigh(sum(K @ K.T for K in Ks))
    O = V[:, :n]
    A = np.linalg.lstsq(O[:-m], O[m:], rcond=None)[0]
    B = []
    for K in Ks:
        rows = np.vstack([K.T[:, m * (c + 1):] @ O[:m * (L - c - 1)] for c in range(L - 1)])
        B.append(np.linalg.svd(rows, full_matrices=False)[2][-1])
    return A, np.array(B).T, O[:m]


def residual(A, B, C, spectra):
    n = len(A)
    out = []
    for j, (Y, z, w) in enumerate(spectra):
        CZ = C @ np.linalg.inv(z[:, None, None] * np.eye(n) - A)
        g = CZ @ B[:, j]
        g = g / np.linalg.norm(g, axis=1, keepdims=True)
        project = lambda V: V - g[..., None] * (g.conj()[:, None, :] @ V)
        ends = np.linalg.qr(B[:, [j]], mode="complete")[0][:, 1:]
        M = project(CZ @ ends * (z * w)[:, None, None]).reshape(-1, n - 1)
        y = project(Y[:, :, None]).reshape(-1)
        M, y = np.vstack([M.real, M.imag]), np.concatenate([y.real, y.imag])
        Q, _ = np.linalg.qr(M / np.linalg.norm(M, axis=0))
        out.append(y - Q @ (Q.T @ y))
    return np.concatenate(out)


def maximum_likelihood(Ys, sigma, A, B, C, offsets, iterations=60, tol=1e-10):
    n, J, m = len(A), B.shape[1], len(C)
    spectra = []
    for Y in Ys:
        N = len(Y)
        F = np.arange(1 if offsets else 0, N // 2 + 1)
        w = np.where((F == 0) | (2 * F == N), 1, 2**0.5)
        spectra.append(((np.fft.rfft(Y / sigma, axis=0) / N**0.5)[F] * w[:, None], np.exp(2j * np.pi * F / N), w))
    split = lambda t: (t[:n * n].reshape(n, n), t[n * n:n * (n + J)].reshape(n, J), t[n * (n + J):].reshape(m, n))
    f = lambda t: residual(*split(t), spectra)
    th = np.concatenate([A.ravel(), B.ravel(), C.ravel()])
    e = f(th)
    cost, lam, r = e @ e, 1e-4, n * J + m * n - J
    for _ in range(iterations):
        Jm = np.empty((len(e), len(th)))
        for i in range(len(th)):
            h = np.zeros(len(th))
            h[i] = 1e-6 * max(1e-2, abs(th[i]))
            Jm[:, i] = (f(th + h) - f(th - h)) / (2 * h[i])
        scale = np.linalg.norm(Jm, axis=0)
        U, s, Vt = np.linalg.svd(Jm / scale, full_matrices=False)
        for _ in range(15):
            step = -(Vt[:r].T @ (s[:r] / (s[:r]**2 + lam * s[0]**2) * (U[:, :r].T @ e))) / scale
            e2 = f(th + step)
            if e2 @ e2 < cost:
                break
            lam *= 10
        else:
            break
        gain = cost - e2 @ e2
        th, e, cost, lam = th + step, e2, e2 @ e2, max(lam / 10, 1e-14)
        if gain < tol * cost:
            break
    cov = (Vt[:r].T / s[:r]**2) @ Vt[:r] / np.outer(scale, scale)
    dof = sum((m - 1) * (len(Y) - offsets) for Y in Ys) - r - (n - 1) * J
    return split(th)[0], cov, cost / dof


def poles(A, cov):
    """Continuous-time eigenvalues, with the standard deviations of their real and imaginary parts."""
    z, V = np.linalg.eig(A)
    W = np.linalg.inv(V)
    out = []
    for i in range(len(z)):
        g = np.zeros(len(cov), complex)
        g[:A.size] = np.outer(W[i], V[:, i]).ravel() / z[i] / T
        sd = [float(np.sqrt(abs(q @ cov @ q))) for q in (g.real, g.imag)]
        s = np.log(z[i] + 0j) / T
        out.append({"re": s.real, "im": s.imag, "sd_re": sd[0], "sd_im": sd[1]})
    return sorted(out, key=lambda p: (p["re"], p["im"]))


def everything():
    folder = pathlib.Path(__file__).resolve().parent / "records"
    true = json.loads((folder / "noise_levels.json").read_text())
    result = {}
    for name, L in PAIRS.items():
        Ys = [np.loadtxt(folder / f"{name}_{tag}.csv", delimiter=",", skiprows=1)[:, 1:] for tag in ("aileron", "rudder")]
        result[name] = {"block_rows": L, "noise_true": true[name]}
        for key, offsets in (("offsets_zero", False), ("offsets_free", True)):
            sigma = noise_levels(Ys, L, 4, offsets)
            A, B, C = intersect(Ys, sigma, L, 4, offsets)
            part = {"start": {"a": A.tolist(), "b": B.tolist(), "c": (C * sigma[:, None]).tolist(), "noise": sigma.tolist()}}
            for tag, levels in (("known", np.array(true[name])), ("estimated", sigma)):
                # The prototype leaves C in the start's units, which only scales the first step.
                A2, cov, chi = maximum_likelihood(Ys, levels, A, B, C, offsets)
                part[tag] = {"poles": poles(A2, cov), "chi_squared_per_degree": chi}
            result[name][key] = part
    return result


def numbers(value):
    if isinstance(value, dict):
        return [x for key in sorted(value) for x in numbers(value[key])]
    if isinstance(value, list):
        return [x for entry in value for x in numbers(entry)]
    return [float(value)]


if __name__ == "__main__":
    path = pathlib.Path(__file__).resolve().parent / "likelihood.json"
    found = everything()
    if "--write" in sys.argv:
        path.write_text(json.dumps(found, indent=1) + "\n")
    committed = numbers(json.loads(path.read_text()))
    print("largest difference", max(abs(a - b) for a, b in zip(numbers(found), committed)))
