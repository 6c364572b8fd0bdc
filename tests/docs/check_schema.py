#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does --json of the program print what docs/json/schema.json says?

    check_schema.py <granum> <schema.json>     in the folder of the data of tests/cli

Each line below is run, and its JSON held against the schema of its command; a key that the schema lacks is a fault. Then every
key of the schema must occur in one of them at least, and faults that are planted must be found.
"""

import copy
import json
import shlex
import shutil
import subprocess
import sys
import tempfile

STATE = "--void-ratio 0.6 --pressure 100kPa"
SCENE = ("--set study.contacts=sphere --set study.densities=dense --set study.pressures=10kPa,20kPa,40kPa --set study.probe_pressures= "
         "--set grain.density=2.65kg/m3")  # a slip, for a warning
FOLDER = tempfile.mkdtemp()
LINES = f"""
estimate {STATE}
estimate {STATE} --grain-shape sand
estimate {STATE} --grain-shape sphere --bounds --tolerance 5% --cement 2%
estimate {STATE} --coordination-number 5 --tolerance 90%
estimate --void-ratio 0.6 --stress-v 200kPa --k0 0.5 --fabric 0.1 --saturation 100%
estimate --sand toyoura --relative-density 60% --pressure 100kPa --strain 0.01%
estimate {STATE} --sizes lognormal:0.35 --rattler-fraction 5% --contact cone --slope 0.3
estimate {STATE} --contact rough --roughness 50nm --uncertainty roughness=10nm
estimate {STATE} --contact flat --punch-radius 3um --preparation dense --rolling 0.1
estimate {STATE} --contact power-law --alpha 1.5 --profile-constant 180 --mechanical-coordination-number 3.5 --rattler-fraction 5%
estimate --void-ratio 0.6 --pressure 0kPa
estimate --void-ratio 1.3 --pressure 100kPa --grain-shape sand
infer {STATE} --vs 280m/s+-2% --predict-pressure 50kPa,400kPa
infer {STATE} --vs 250m/s --grain-shape sand --saturation 100% --predict-pressure 400kPa
infer {STATE} --vs 280m/s+-2% --vp 480m/s+-2% --grain-shape sphere --contacts rough
infer {STATE} --vs 2800m/s --grain-shape sphere
infer --table beads_speeds.csv --void-ratio 0.6 --grain glass --growth fitted
infer --table borehole.csv --unit-weight 18kN/m3
infer --table borehole.csv --water-table 2m --grain-shape sphere
sweep --void-ratio 0.6 --from 10kPa --to 100kPa --points 2 --rungs 0,3 --laws
sweep --void-ratio 0.6 --path txc --from 100kPa --eta 0.5 --points 2 --rungs 1,2
sweep --void-ratio 0.6 --depth 0m..10m --points 2 --water-table 2m
sweep --layers layers.csv --depth 1m..20m --points 3
sweep --layers layers.csv --depth 1m..20m --points 3 --strain 0.001%..1% --for table
sweep --table sand_rows.csv
sweep --table sand_rows.csv --strain 0.001%..1% --for table
sweep --table sweep_states.csv
fit isotropic_by_hand.csv
fit fit_speeds.csv
fit hv_dense_cone.csv
fit hv_dense_cone.csv --sum-only --void-ratio-function none --weights absolute
analyse analyse_lattice.grains analyse_lattice.contacts --grain-density 2650kg/m3 --modes 2 --probes analyse_probes.csv
analyse analyse_lattice.grains analyse_lattice.contacts --no-network
analyse analyse_apart.csv --box 4mm,4mm,4mm
analyse analyse_chain_contacts.csv
analyse ../../io/data/mercury_chain.data ../../io/data/mercury_chain.fstat
analyse ../../io/data/lammps_chain.atoms ../../io/data/lammps_chain.contacts --stress analyse_stress_frames.csv
analyse ../../io/data/lammps_box.atoms ../../io/data/lammps_box.contacts --window ..,..,1mm..3mm
analyse ../../io/data/lammps_box.atoms ../../io/data/lammps_box.contacts --profile z:3 --no-network
verify {SCENE} --grains 120 --set study.probe_pressures=20kPa
verify {SCENE} --grains 120 --seeds 2 --set study.contacts=rough --set contact.roughness=1um --set study.probe_pressures=10kPa,20kPa
reproduce {SCENE} --grains 80 --set shear.paths=TXC --set shear.inertial_number=1e-3 --set shear.largest_strain=0.001 --out {FOLDER}/experiment
trade --quick --grains 40 --set study.pressures=10kPa,20kPa,40kPa --set grain.density=2.65kg/m3
plan {SCENE} --grains 120 --set study.densities=dense,loose
export lammps {SCENE} --grains 60 --out {FOLDER}/deck
"""
TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "integer": int, "number": (int, float), "null": type(None)}


class Schema:
    """The part of JSON Schema that schema.json uses; `seen` are the property schemas that a value was held against."""

    def __init__(self, schema):
        self.whole, self.seen = schema, set()

    def faults(self, value, schema, at=""):
        known = {"$ref", "description", "const", "enum", "type", "anyOf", "properties", "required", "additionalProperties", "items",
                 "minimum", "maximum"}
        if unknown := set(schema) - known:
            return [f"the schema of {at} has {unknown}, which this test does not know"]
        found = []
        if "$ref" in schema:
            found += self.faults(value, self.whole["$defs"][schema["$ref"].rpartition("/")[2]], at)
        if "anyOf" in schema:
            of_each = [self.faults(value, one, at) for one in schema["anyOf"]]
            found += [] if not all(of_each) else min(of_each, key=len)
        if "const" in schema and value != schema["const"] or "enum" in schema and value not in schema["enum"]:
            found.append(f"{at} = {value!r}")
        kinds = [schema["type"]] if isinstance(schema.get("type"), str) else schema.get("type", [])
        if kinds and not any(isinstance(value, TYPES[kind]) and isinstance(value, bool) == (kind == "boolean") for kind in kinds):
            return found + [f"{at} = {str(value)[:60]} is no {kinds}"]
        if "minimum" in schema and value < schema["minimum"] or "maximum" in schema and value > schema["maximum"]:
            found.append(f"{at} = {value} is out of range")
        if isinstance(value, dict):
            found += [f"{at}/{key} is missing" for key in schema.get("required", []) if key not in value]
            for key, member in value.items():
                if key in schema.get("properties", {}):
                    self.seen.add(id(schema["properties"][key]))
                    found += self.faults(member, schema["properties"][key], f"{at}/{key}")
                elif schema.get("additionalProperties") is False:
                    found.append(f"{at}/{key} is not in the schema")
                elif isinstance(schema.get("additionalProperties"), dict):
                    found += self.faults(member, schema["additionalProperties"], f"{at}/{key}")
        for k, member in enumerate(value if isinstance(value, list) and "items" in schema else []):
            found += self.faults(member, schema["items"], f"{at}/{k}")
        return found

    def never_seen(self, schema=None, at=""):
        schema = self.whole if schema is None else schema
        for key, member in schema.items() if isinstance(schema, dict) else []:
            if key == "properties":
                yield from (f"{at}/{name}" for name, one in member.items() if id(one) not in self.seen)
            yield from self.never_seen(member, f"{at}/{key}" if key not in ("properties", "$defs") else at)
        for member in schema if isinstance(schema, list) else []:
            yield from self.never_seen(member, at)


program, path = sys.argv[1:]
with open(path, encoding="utf-8") as file:
    whole = json.load(file)
schema, faults, printed = Schema(whole), [], {}
for line in filter(None, LINES.splitlines()):
    run = subprocess.run([program, *shlex.split(line), "--json"], capture_output=True, text=True)
    try:
        printed[line] = json.loads(run.stdout)
    except ValueError:
        faults.append(f"{line}: no JSON, exit code {run.returncode}: {run.stderr}")
        continue
    faults += [f"{line}: {fault}" for fault in schema.faults(printed[line], whole["$defs"][line.split()[0]])]
shutil.rmtree(FOLDER)
faults += [f"{at} occurs in no line of this test" for at in schema.never_seen()]
# Planted: a key too many, one too few, a value of another kind.
for plant in (lambda x: x.update(more=1), lambda x: x.pop("notes"), lambda x: x["inputs"].update(void_ratio="0.6")):
    wrong = copy.deepcopy(printed[f"estimate {STATE}"])
    plant(wrong)
    if not Schema(whole).faults(wrong, {"anyOf": whole["anyOf"]}):
        faults.append("a planted fault is not found")
print("\n".join(faults) or f"{len(printed)} lines agree with the schema")
sys.exit(bool(faults))
