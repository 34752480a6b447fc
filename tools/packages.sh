#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Install those of the named Debian packages that are missing; say nothing when all are there. What cannot be
# installed is left out with a line: what needs it says so itself.
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
get() { $as env DEBIAN_FRONTEND=noninteractive apt-get -qy --no-install-recommends install "$@" </dev/null >&2; }
$as apt-get -q update </dev/null >&2
get $missing && exit 0
for p in $missing; do # one that cannot be had does not keep the others out
    get "$p" || echo "package $p cannot be installed: left out" >&2
done
exit 0
