#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: the meander authors
# fresh_system.sh [BUILD]: makes the Debian package for the Debian that this runs on, installs it with apt in a smallest
# system of the same release, and uses it there. Needs root; installs what it lacks. BUILD is a build folder to take the
# package from; without it ./meander makes one.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
[ "$(id -u)" -eq 0 ] || { echo "fresh_system.sh: root is needed for a system of its own (debootstrap, chroot)" >&2; exit 2; }
. /etc/os-release
step() { printf '\n== %s (%d s)\n' "$*" "$SECONDS"; }

step "package for $VERSION_CODENAME"
build=${1:-build/${MEANDER_PRESET:-release}}
[ $# -gt 0 ] || ./meander --version
cmake --build "$build" --target meander
DEBIAN_FRONTEND=noninteractive apt-get -qq -y install --no-install-recommends debootstrap dpkg-dev file >/dev/null
rm -f "$build"/*.deb
(cd "$build" && cpack -G DEB)
package=$(realpath "$build"/meander_*.deb)
dpkg-deb --field "$package" Package Version Architecture Depends Installed-Size
if command -v lintian >/dev/null; then lintian --fail-on error --suppress-tags initial-upload-closes-no-bugs "$package"; fi

step "a smallest system"
work=$(mktemp -d)
root="$work/root"
finish() {
  mountpoint -q "$root/proc" && umount "$root/proc"
  rm -rf --one-file-system "$work"
}
trap finish EXIT
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep '/debian/*$' | head -n 1)
debootstrap --variant=minbase --include=ca-certificates "$VERSION_CODENAME" "$root" "$mirror" >"$work/log" || { tail "$work/log"; exit 1; }
cp /etc/apt/apt.conf.d/* "$root/etc/apt/apt.conf.d/"  # a proxy, if there is one
cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
mount -t proc proc "$root/proc"
cp "$package" "$root/tmp/meander.deb"

inside() { env -i HOME=/root TERM=dumb LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin \
  chroot "$root" bash -euo pipefail -c "mkdir -p /root/work && cd /root/work && $1"; }

step "apt installs it"
inside "apt-get -qq update && apt-get -qq -y -o Dpkg::Use-Pty=0 install --no-install-recommends /tmp/meander.deb >/tmp/apt.log 2>&1 || { cat /tmp/apt.log; exit 1; }"

step "and it works there"
inside "meander --version"
inside "meander examples/first_run.lua && ls -l out"
inside "meander convert worlds/office.toml office.png && meander convert office.png office.toml"
inside "printf '1 + 1\nworld.open \"worlds/office.toml\"\n' | meander -i --no-rc"
inside "bash -c '. /usr/share/bash-completion/completions/meander && complete -p meander'"
inside "apt-get -qq -y -o Dpkg::Use-Pty=0 install --no-install-recommends man-db >/dev/null 2>&1 && man -w meander"

step "and leaves nothing behind"
inside "apt-get -qq -y -o Dpkg::Use-Pty=0 purge meander >/dev/null && ! command -v meander && ! ls -d /usr/share/meander /usr/lib/meander 2>/dev/null"
echo "fresh_system.sh: passed"
