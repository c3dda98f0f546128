"""A nuclear-norm fit by the alternating direction method of multipliers: the oracle of src/regularized/tests.rs.

    python nuclear_norm.py          prints the largest difference from the committed file
    python nuclear_norm.py --write  rewrites nuclear_norm.json

Needs numpy. It shares nothing with the conic solver: the Hankel matrices are split off and their singular values shrunk, 200 000 times.
The objective is the one stated in src/regularized.rs; the data are a second-order system driven by white noise, with noise on its output.
"""
import json, pathlib, sys
import numpy as np

L, R, D, N, LAMBDA = 2, 8, 5, 160, 2e-3
TARGET = pathlib.Path(__file__).resolve().with_suffix(".json")


def record():
    rng = np.random.default_rng(7)
    u = rng.standard_normal(N).round(6)
    y = np.zeros(N)
    for k in range(2, N):
        y[k] = 1.2 * y[k - 1] - 0.72 * y[k - 2] + u[k] - 0.3 * u[k - 1]
    return u, (y + 0.3 * rng.standard_normal(N)).round(6)


def hankel_maps(indices, parameters):
    rows = (len(indices) + 1) // 2
    columns = len(indices) + 1 - rows
    maps = np.zeros((rows * columns, parameters))
    for i in range(rows):
        for j in range(columns):
            maps[i * columns + j, indices[i + j]] = 1
    return maps, (rows, columns)


def solve(u, y):
    k = np.arange(R, N - max(L, D))
    phi = np.stack([-y[k + i] for i in range(1, L)] + [u[k - i] for i in range(-D, R + 1)], 1)
    psi = y[k + L]
    s_i, s_o = np.sqrt(np.mean(u[k] ** 2)), np.sqrt(np.mean(psi**2))
    units = np.r_[np.ones(L - 1), np.full(D + R + 1, s_i / s_o)]
    A, b = phi / units / s_o / len(k) ** 0.5, psi / s_o / len(k) ** 0.5
    zero = L - 1 + D
    maps = [hankel_maps([zero + i for i in range(1, R + 1)], A.shape[1]), hankel_maps([zero - i for i in range(1, D + 1)], A.shape[1])]
    rho = 0.05
    left = np.linalg.inv(A.T @ A + rho * sum(M.T @ M for M, _ in maps))
    Z = [np.zeros(M.shape[0]) for M, _ in maps]; U = [z.copy() for z in Z]
    for _ in range(200000):
        x = left @ (A.T @ b + rho * sum(M.T @ (z - v) for (M, _), z, v in zip(maps, Z, U)))
        for n, (M, shape) in enumerate(maps):
            left_vectors, s, right_vectors = np.linalg.svd((M @ x + U[n]).reshape(shape), full_matrices=False)
            Z[n] = (left_vectors * np.maximum(s - LAMBDA / rho, 0) @ right_vectors).ravel()
            U[n] += M @ x - Z[n]
    gap = max(np.abs(M @ x - z).max() for (M, _), z in zip(maps, Z))
    norms = [np.linalg.svd((M @ x).reshape(shape), compute_uv=False) for M, shape in maps]
    objective = 0.5 * np.sum((b - A @ x) ** 2) + LAMBDA * sum(s.sum() for s in norms)
    print("splitting residual", gap, "singular values", norms)
    return x / units, objective


u, y = record()
theta, objective = solve(u, y)
answer = {"orders": [L, R, D], "lambda": LAMBDA, "input": u.tolist(), "output": y.tolist(), "theta": theta.tolist(), "objective": objective}
if "--write" in sys.argv:
    TARGET.write_text(json.dumps(answer) + "\n")
committed = json.loads(TARGET.read_text())
print("largest difference from the committed file:", np.abs(np.array(committed["theta"]) - theta).max())
