# SPDX-License-Identifier: BSD-3-Clause
# Sourced by scripts that try something on a fresh Debian 12 below a folder (debootstrap, chroot; as root, with a
# network). MIRROR is where its packages come from.

MIRROR=${MIRROR:-http://deb.debian.org/debian}
clean_system_folder=$(mktemp -d)
clean_systems=()

# clean_system_remove: unmounts and removes all that was made.
clean_system_remove() {
  local system
  for system in "${clean_systems[@]}"; do
    umount "$system/proc" || return 1 # never remove what is below a mount
  done
  rm -rf --one-file-system "$clean_system_folder"
}
trap clean_system_remove EXIT

# clean_system_check: whether such a system can be made here.
clean_system_check() {
  if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
    echo "$0: needs root and debootstrap (apt-get install debootstrap)" >&2
    exit 2
  fi
}

# clean_system NAME: makes one; sets $root, its folder. The first is fetched, others are copies of it as it was then.
clean_system() {
  local fresh=$clean_system_folder/fresh
  if [ ! -e "$fresh" ]; then
    debootstrap --variant=minbase bookworm "$fresh" "$MIRROR" >"$clean_system_folder/log" 2>&1 || {
      tail -n 20 "$clean_system_folder/log" >&2
      exit 1
    }
  fi
  root=$clean_system_folder/$1
  cp -a "$fresh" "$root"
  cp -L /etc/resolv.conf "$root/etc/resolv.conf"
  mount -t proc proc "$root/proc"
  clean_systems+=("$root")
}

# inside COMMAND...: runs it in $root with a plain environment.
inside() {
  chroot "$root" env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive "$@" </dev/null
}

# timed WORDS -- COMMAND...: runs it, prints the words and the seconds; ends the script if it fails.
timed() {
  local words="" start=$SECONDS
  while [ "$1" != -- ]; do
    words="$words $1"
    shift
  done
  shift
  if ! "$@" >"$clean_system_folder/log" 2>&1; then
    tail -n 40 "$clean_system_folder/log" >&2
    echo "$0: failed:$words" >&2
    exit 1
  fi
  printf '%6d s %s\n' $((SECONDS - start)) "$words"
}
