#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Debian packages on a bare Debian 12, uses them there, and removes them. Needs root, debootstrap and a
# mirror of Debian:  tests/consumer/bare_debian.sh <folder of .deb files> <new folder for the system> [mirror]
set -euo pipefail
packages=$(readlink -f "$1") root=$2 mirror=${3:-http://deb.debian.org/debian}
[ -e "$root/etc/debian_version" ] || debootstrap --variant=minbase bookworm "$root" "$mirror"
root=$(readlink -f "$root")
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@"; }
find_files() { inside find /usr /etc /var/lib -xdev -not -path '/var/lib/apt/*' -not -path '/var/lib/dpkg/*' -iname '*granum*'; }

rm -rf "$root/packages"
cp -r "$packages" "$root/packages"
inside apt-get -q update
inside sh -c 'apt-get -q -y install --no-install-recommends /packages/*.deb'
inside granum estimate --void-ratio 0.6 --pressure 100kPa --json | grep '"shear_modulus"' >/dev/null
inside granum verify --set study.grains=60 --set study.seeds=1 --out /tmp/verify --force --quiet | grep 'sphere' >/dev/null
inside python3 /usr/share/doc/granum/examples/python/modulus_and_range.py | grep 'G_vh' >/dev/null
# A program on the libraries, by CMake's files and by pkg-config.
inside sh -c 'apt-get -q -y install --no-install-recommends g++ pkg-config'
inside sh -c 'cd /tmp && g++ -std=c++20 /usr/share/doc/granum/examples/01_quick_modulus.cpp -o quick $(pkg-config --cflags --libs granum) && ./quick'
inside sh -c 'apt-get -q -y purge granum libgranum-dev python3-granum granum-doc'
left=$(find_files)
[ -z "$left" ] || {
  echo "left behind: $left" >&2
  exit 1
}
echo "installed, used and removed on $(inside cat /etc/debian_version)"
