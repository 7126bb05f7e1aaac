#!/bin/sh
# Installs the packages of build/packages in a minimal Debian 12 below FOLDER and fills a small die there: what a user of
# a fresh machine meets. As root; needs debootstrap. The mirror is this machine's (DIEFILL_MIRROR names another).
#   sh app/packaging/try_package.sh FOLDER
set -eu
root=${1:?give a folder for the minimal system}
packages=$(cd "$(dirname "$0")/../../build/packages" && pwd)
mirror=${DIEFILL_MIRROR:-$(apt-cache policy | sed -n 's/^ *[0-9]* \(http[^ ]*\) bookworm\/main.*/\1/p' | head -n 1)}

if [ ! -x "$root/usr/bin/apt-get" ]; then
  debootstrap --variant=minbase bookworm "$root" "$mirror"
fi
mkdir -p "$root/packages"
cp "$packages"/diefill_*.deb "$packages"/python3-diefill_*.deb "$root/packages"
mkdir -p "$root/proc"
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT
in_root() { chroot "$root" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"; }
in_root apt-get update -qq
in_root sh -c 'apt-get install -y -qq --no-install-recommends /packages/*.deb' >"$root/packages/install.log"

in_root sh -c '! command -v c++ && ! command -v gcc'
in_root diefill --version
in_root sh -c 'cd /tmp && rm -rf my_die out && diefill new my_die --kind ring && diefill run my_die/fill.toml --quiet'
in_root ls -l /tmp/out/my_die
in_root python3 -c 'import diefill; r = diefill.read("/tmp/out/my_die"); print(r, r.figures["fill_ratio"])'
