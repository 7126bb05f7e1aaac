#!/bin/sh
# Installs the packages of build/packages in a minimal Debian 12 below FOLDER and fills a small die there as an ordinary
# user: what a user of a fresh machine meets. Then installs a compiler and builds the example of libdiefill-dev. As root;
# needs debootstrap. The mirror is this machine's (DIEFILL_MIRROR names another). The system is kept for the next call,
# which takes the packages anew and removes the compiler first.
#   sh app/packaging/try_package.sh FOLDER
set -eu
root=${1:?give a folder for the minimal system}
packages=$(cd "$(dirname "$0")/../../build/packages" && pwd)
mirror=${DIEFILL_MIRROR:-$(apt-cache policy | sed -n 's/^ *[0-9]* \(http[^ ]*\) bookworm\/main.*/\1/p' | head -n 1)}
for name in diefill python3-diefill libdiefill-dev; do
  count=$(find "$packages" -maxdepth 1 -name "${name}_*.deb" | wc -l)
  [ "$count" -eq 1 ] || {
    echo "try_package: $count packages $name in $packages, 1 is wanted; empty the folder and run cpack again" >&2
    exit 1
  }
done

if [ ! -x "$root/usr/bin/apt-get" ]; then
  debootstrap --variant=minbase bookworm "$root" "$mirror"
fi
rm -rf "$root/packages"
mkdir -p "$root/packages"
cp "$packages"/*.deb "$root/packages"
mkdir -p "$root/proc"
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT
in_root() { chroot "$root" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"; }
as_user() { in_root runuser -l worker -c "set -eu; $1"; }
# Again where the same version is installed: it may be of an earlier build.
install() {
  in_root apt-get install -y -qq --no-install-recommends --reinstall --allow-downgrades "$@" >>"$root/packages/install.log"
}

in_root apt-get update -qq
for package in libdiefill-dev g++ cmake make; do
  ! in_root dpkg -s "$package" >/dev/null 2>&1 || in_root apt-get purge -y -qq "$package" >>"$root/packages/install.log"
done
in_root apt-get autoremove --purge -y -qq >>"$root/packages/install.log"
in_root sh -c '! command -v c++ && ! command -v gcc'
version=$(basename "$packages"/diefill_*.deb | cut -d _ -f 2-)
install "/packages/diefill_$version" "/packages/python3-diefill_$version"
in_root id worker >/dev/null 2>&1 || in_root useradd --create-home --shell /bin/sh worker

in_root diefill --version
as_user 'rm -rf my_die out
  diefill new my_die --kind ring
  diefill run my_die/fill.toml --quiet
  ls -l out/my_die
  python3 -c "import diefill; r = diefill.read(\"out/my_die\"); print(r, r.figures[\"fill_ratio\"])"'

install g++ cmake make "/packages/libdiefill-dev_$version"
as_user 'rm -rf library
  cp -r /usr/share/diefill/sample_tools/library .
  cmake -S library -B library/build
  cmake --build library/build
  library/build/coordination'
for package in diefill python3-diefill libdiefill-dev; do
  in_root test -s "/usr/share/doc/$package/copyright"
done
