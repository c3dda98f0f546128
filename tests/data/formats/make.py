"""Writes the files of this folder: one short record in the formats of other programs.

pip install numpy scipy h5py hdf5storage zstandard; python make.py
"""

from pathlib import Path

import h5py
import hdf5storage
import numpy as np
import scipy.io
import zstandard

HERE = Path(__file__).parent
k = np.arange(120)
time, p, r = k / 10, k * k % 97 - 48.0, k * k * 3 % 89 - 44.0
xyz = np.stack((p, r, p - r), axis=1)

log = {"time": time, "imu": {"p": p, "r": r, "name": "left"}, "xyz": xyz, "count": k.astype("int16")}
for name, packed in (("structure-v6.mat", False), ("structure-v7.mat", True)):
    scipy.io.savemat(HERE / name, {"log": log, "rate": 10.0}, do_compression=packed, oned_as="column")
scipy.io.savemat(HERE / "rows.mat", {"time": time[None, :], "x": xyz.T})
hdf5storage.savemat(str(HERE / "structure-v73.mat"), {"log": log}, format="7.3", oned_as="column")

with h5py.File(HERE / "groups.h5", "w") as file:
    imu = file.create_group("log/imu")
    file["log/time"] = time
    imu.create_dataset("p", data=p, compression="gzip", shuffle=True, chunks=(50,))
    imu.create_dataset("r", data=r.astype(">f4"))
    file["log/xyz"] = xyz
    file["log/on"] = k % 2 == 0
    table = np.zeros(120, dtype=[("a", "<i2"), ("b", "<f8")])
    table["a"], table["b"] = k, p
    file["log/table"] = table
    file["log/note"] = "a flight"

table = np.zeros(120, dtype=[("time", "<f8"), ("p", ">f4"), ("mode", "S4"), ("xyz", "<f8", (3,)), ("n", "u1")])
table["time"], table["p"], table["xyz"], table["n"] = time, p, xyz, k
np.save(HERE / "structured.npy", table)
np.savez(HERE / "structured.npz", table=table)
np.savez(HERE / "rows.npz", time=time, x=xyz.T.copy(), n=k.astype("<i4"))

text = "time,p,r\n" + "".join(f"{a},{b},{c}\n" for a, b, c in zip(time, p, r))
half = len(text) // 2
pack = zstandard.ZstdCompressor().compress
(HERE / "two-frames.csv.zst").write_bytes(pack(text[:half].encode()) + pack(text[half:].encode()))
