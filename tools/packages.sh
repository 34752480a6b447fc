#!/bin/sh
# Install those of the named Debian packages that are missing; say nothing when all are there.
if ! command -v dpkg-query >/dev/null; then
    echo "no Debian package system here; needed: $*" >&2
    exit 0
fi
missing=
for p in "$@"; do
    case $(dpkg-query -W -f='${Status}' "$p" 2>/dev/null) in
    *' installed') ;;
    *) missing="$missing $p" ;;
    esac
done
[ -n "$missing" ] || exit 0
echo "installing$missing" >&2
as=
if [ "$(id -u)" != 0 ]; then as=sudo; fi
$as apt-get -q update </dev/null >&2 &&
    $as env DEBIAN_FRONTEND=noninteractive apt-get -qy --no-install-recommends install $missing </dev/null >&2
