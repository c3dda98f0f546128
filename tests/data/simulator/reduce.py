"""Cuts the collection of simulator records down to what the study reads: the files of this folder.

    python reduce.py COLLECTION

COLLECTION is the folder that the collection's own make.py writes: records with more columns and kinds, and its truth.json.
Digits are copied as they stand. The same collection gives the same bytes.
"""
import csv
import gzip
import json
import pathlib
import sys

KINDS = ['clean', 'large', 'col05', 'actlag10', 'multistep', 'noise', 'bias', 'quantised', 'delay']
# What the surfaces did is read of these.
RECORDED = ['clean', 'noise', 'delay', 'turb1', 'turb2']
COLUMNS = ['time', 'beta', 'p', 'r']
here = pathlib.Path(__file__).resolve().parent
collection = pathlib.Path(sys.argv[1])
truth = json.loads((collection / 'truth.json').read_text())

def cut(name, columns):
    with gzip.open(collection / name, 'rt', newline='') as source:
        rows = list(csv.reader(source))
    places = [rows[0].index(column) for column in columns]
    text = ''.join(','.join(row[place] for place in places) + '\n' for row in rows)
    return (here / name).write_bytes(gzip.compress(text.encode(), compresslevel=9, mtime=0))


size = 0
for aircraft in truth['aircraft']:
    for kind in dict.fromkeys(KINDS + RECORDED):
        for surface in ['aileron', 'rudder']:
            moved = [f'd_{surface}'] if kind in RECORDED else []
            size += cut(f'{aircraft}_{surface}_{kind}.csv.gz', COLUMNS + moved)
    size += cut(f'{aircraft}_both.csv.gz', COLUMNS + ['d_aileron', 'd_rudder'])

reduced = {
    name: {
        'about': aircraft['about'],
        'altitude_m': round(aircraft['trim']['altitude_m'], 1),
        'true_airspeed_m_s': round(aircraft['trim']['speed_mps'], 1),
        'roll': aircraft['modes']['roll'],
        'dutch_roll': aircraft['modes']['dutch_roll'],
        'spiral': aircraft['modes']['spiral'],
    }
    for name, aircraft in truth['aircraft'].items()
}
(here / 'truth.json').write_text(json.dumps(reduced, indent=2) + '\n')
print(f'{size} bytes of records')
