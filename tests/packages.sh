#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes the Debian packages, has lintian look at them, installs them in a fresh Debian, uses and removes them. As root, with
# a network; some ten minutes on two processors.
#
#   tests/packages.sh           for the Debian that it runs on
#   tests/packages.sh RELEASE   for another, as trixie: in a bare one, where all is built from nothing; half an hour
set -eu
cd "$(dirname "$0")/.."
. /etc/os-release
release=${1:-$VERSION_CODENAME}
# bare FOLDER: a bare Debian, with /proc; its apt runs as root, for nobody else may enter the folder.
bare() {
  debootstrap --variant=minbase "$release" "$1" >/dev/null
  echo 'APT::Sandbox::User "root";' >"$1/etc/apt/apt.conf.d/root"
  mount -t proc proc "$1/proc"
}
fresh=$(mktemp -d)
trap 'umount "$fresh/proc" 2>/dev/null || true; rm -rf --one-file-system "$fresh"' EXIT

if [ "$release" != "$VERSION_CODENAME" ]; then
  apt-get install -y --no-install-recommends debootstrap >/dev/null
  bare "$fresh"
  mkdir "$fresh/coppermoon"
  tar -c --exclude=./build --exclude=./.git . | tar -x -C "$fresh/coppermoon"
  chroot "$fresh" env -i PATH="$PATH" HOME=/root LC_ALL=C.UTF-8 /coppermoon/tests/packages.sh
  exit
fi

sh examples/build.sh coppermoon_test_main packages.tests.debian
apt-get install -y --no-install-recommends debootstrap dpkg-dev lintian >/dev/null
cmake --workflow --preset debian
packages=$PWD/build/debian

# the address is that of whoever publishes them
lintian --allow-root --fail-on error,warning --suppress-tags bogus-mail-host,bogus-mail-host-in-debian-changelog \
  "$packages"/*.deb

bare "$fresh"
mkdir "$fresh/packages" "$fresh/consumer"
cp "$packages"/*.deb "$fresh/packages"
cp -r tests/package/contacts/. "$fresh/consumer"
chroot "$fresh" sh -eu <<'END'
export DEBIAN_FRONTEND=noninteractive HOME=/tmp LC_ALL=C
cd /tmp
install() { apt-get install -y --no-install-recommends "$@" >/dev/null; }
apt-get update >/dev/null

install /packages/coppermoon_*.deb
coppermoon --version
coppermoon bake 2018-07-27T20:00:00Z --unshadowed --albedo-map built-in --texture-width 256 -o moon.exr
test -s /usr/share/man/man1/coppermoon-bake.1.gz
test -s /usr/share/bash-completion/completions/coppermoon
install zsh
test "$(zsh -fc 'autoload -U compinit; compinit -D; print $_comps[coppermoon]')" = _coppermoon
test -s /usr/share/coppermoon/coppermoon_blender.zip

install /packages/coppermoon-openimageio_*.deb openimageio-tools
printf 'instant = "2018-07-27T20:00:00Z"\nunshadowed = true\nalbedo-map = "built-in"\ntexture-width = 256\n' >moon.eclipse
OIIO_LIBRARY_PATH=$(dirname "$(dpkg -L coppermoon-openimageio | grep 'imageio.so$')") oiiotool --diff moon.eclipse moon.exr

install /packages/libcoppermoon-dev_*.deb cmake g++ ninja-build pkg-config
cmake -S /consumer -B consumer -G Ninja >/dev/null
cmake --build consumer >/dev/null

install /packages/python3-coppermoon_*.deb
python3 -c 'import coppermoon; print(coppermoon.bake("2018-07-27T20:00:00Z", unshadowed=True, albedo_map="built-in", width=256))'

dpkg -l | grep coppermoon
apt-get purge -y coppermoon libcoppermoon-dev coppermoon-openimageio python3-coppermoon >/dev/null
find / -xdev \( -name proc -o -name packages -o -path /tmp \) -prune -o -name '*coppermoon*' -print |
  grep -v '^/consumer\|^/var/lib/apt\|^/var/cache/apt' >left || true
if [ -s left ]; then echo "left behind:"; cat left; exit 1; fi
echo "installed, used, removed"
END
