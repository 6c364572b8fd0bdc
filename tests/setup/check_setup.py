#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/setup.sh on systems that are made up:  check_setup.py <source tree> <scratch folder>

A folder of substitutes for dpkg-query, apt-get, apt-cache and id, which read what is installed and offered from files and note what
they were asked.
"""

import pathlib
import re
import shutil
import subprocess
import sys

root, scratch = (pathlib.Path(text).resolve() for text in sys.argv[1:3])
IN_LIST = f"in_list() {{ grep -qx -e all -e \"$2\" '{scratch}/'\"$1\"; }}\n"
PROGRAMS = {
    "dpkg-query": IN_LIST + 'in_list INSTALLED "${@: -1}" && echo installed\n',
    "apt-cache": IN_LIST + "echo \"$2:\"; in_list OFFERED \"$2\" && echo '  Candidate: 1.0-1' || echo '  Candidate: (none)'\n",
    "apt-get": IN_LIST + f"""
simulated=0 names=()
for word; do
  case "$word" in
  -s) simulated=1 ;;
  --print-uris) echo "'http://somewhere/a.deb' a.deb 2000001 SHA256:0"; exit 0 ;;
  update) echo update >>'{scratch}/log'; cat '{scratch}/AFTER_UPDATE' >>'{scratch}/OFFERED'; exit 0 ;;
  -* | DPkg::* | install) ;;
  *) names+=("$word") ;;
  esac
done
for name in "${{names[@]}}"; do in_list OFFERED "$name" || exit 100; done
[ $simulated = 1 ] || echo "install ${{names[*]}}" >>'{scratch}/log'
""",
}
failures = []


def expect(what, code, log, text, *arguments, installed="", offered="", after_update="", without="", user=0):
    """Packages by their names, "all" for every one; what is done is noted in the log, and the output has the text."""
    shutil.rmtree(scratch, ignore_errors=True)
    (scratch / "bin").mkdir(parents=True)
    for name, packages in ("INSTALLED", installed), ("OFFERED", offered), ("AFTER_UPDATE", after_update), ("log", ""):
        (scratch / name).write_text("".join(package + "\n" for package in packages.split()))
    for tool in "bash", "env", "sed", "grep", "cat":
        (scratch / "bin" / tool).symlink_to(shutil.which(tool))
    for name, script in {**PROGRAMS, "id": f"echo {user}\n"}.items():
        if name != without:
            (scratch / "bin" / name).write_text(f"#!{shutil.which('bash')}\n{script}")
            (scratch / "bin" / name).chmod(0o700)
    run = subprocess.run([shutil.which("bash"), root / "scripts/setup.sh", *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                         text=True, env={"PATH": str(scratch / "bin")})
    did = (scratch / "log").read_text().strip()
    if run.returncode != code or not re.fullmatch(log, did, re.S) or text not in run.stdout:
        failures.append(f"{what}: exit code {run.returncode} instead of {code}, did '{did}', not '{log}'; said:\n{run.stdout}")


expect("nothing missing", 0, "", "", "run", installed="all")
expect("not a purpose", 2, "", "usage: scripts/setup.sh", "everything", installed="all")
expect("lists that know all", 0, "install ninja-build .*libfmt-dev", " packages (1 files of 3 MB are fetched, with what they need): ninja-build",
       "run", installed="g++ cmake", offered="all")
expect("lists not yet fetched", 0, "update\ninstall cmake ninja-build .*", "", "run", installed="g++", after_update="all")
expect("packages that the system has not", 3, "update", "this system offers no package libeigen3-dev ", "run", offered="cmake",
       after_update="g++ ninja-build")
expect("no apt", 3, "", "this system has no apt-get", "run", offered="all", without="apt-get")
expect("no root", 3, "", "installing them needs root", "test", offered="all", user=1000)
expect("nothing missing, no root", 0, "", "", "test", installed="all", user=1000)
print("\n".join(failures))
sys.exit(bool(failures))
