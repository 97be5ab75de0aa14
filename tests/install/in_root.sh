#!/bin/sh
# in_root.sh ROOT - a hook of mmdebstrap's: installs the packages of $DEBS below ROOT, a fresh Debian, uses them there and removes
# them again. What it writes into the file $SAID the test compares.
set -eu
root=$1
exec >"$SAID"
cd "$(mktemp -d)"
listed() {
    (cd "$root" && find . -xdev \( -path ./proc -o -path ./sys -o -path ./dev -o -path ./tmp -o -path ./run -o -path ./var/cache -o -path ./var/log \
        -o -path ./var/lib/apt -o -path ./var/lib/dpkg -o -name '*.pyc' -o -path ./etc/ld.so.cache \) -prune -o -print | sort)
}
in_root() {
    chroot "$root" env DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@"
}
listed >before
cp "$DEBS"/*.deb "$root/tmp"
in_root sh -c 'apt-get install -qy --no-install-recommends /tmp/*.deb' >installed.log 2>&1 || { tail -20 installed.log >&2; exit 1; }
echo "picture $(in_root tia -k a -s 320x240 --checksum -d none -i none -n 1)"
export PKG_CONFIG_SYSROOT_DIR="$root" PKG_CONFIG_LIBDIR="$root/usr/lib/$TRIPLET/pkgconfig"
# PKG_CONFIG_SYSROOT_DIR is not put before what the compiler would look through anyway.
flags="-I$root/usr/include -L$root/usr/lib/$TRIPLET -L$root/lib/$TRIPLET $(pkg-config --cflags --libs tia)"
gcc -std=c11 "$SOURCES/tests/boards/example_main.c" -I"$SOURCES/port" $flags -o "$root/tmp/example"
echo "example $(in_root /tmp/example)"
gcc -std=c11 "$SOURCES/tests/install/client.c" $flags -o "$root/tmp/client"
echo "client $(in_root /tmp/client)"
echo "needs $(readelf -d "$root/tmp/client" | sed -n 's/.*NEEDED.*\[\(libtia.*\)\]/\1/p')"
echo "page $(zcat -f "$root"/usr/share/man/man3/tia_bvh.3* | grep -c tia_bvh_build)"
echo "guide $(ls "$root/usr/share/doc/tia/docs/library.md"* | wc -l)"
in_root apt-get purge -qy --autoremove tia libtia0 libtia-dev tia-doc >removed.log 2>&1 || { tail -20 removed.log >&2; exit 1; }
listed >after
diff before after | sed 's/^/left /' | head -20
