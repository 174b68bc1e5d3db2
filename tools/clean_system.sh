# SPDX-License-Identifier: BSD-3-Clause
# Sourced by scripts that try something on a fresh Debian 12 below a folder (debootstrap, chroot; as root, with a
# network). MIRROR is where its packages come from: as a rule where this machine's do.

MIRROR=${MIRROR:-$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep -v security | head -n 1)}
clean_system_folder=$(mktemp -d)
clean_system_mounts=()

# mount_below OPTIONS...: as mount; undone at the end. The last word is the folder.
mount_below() {
  mount "$@" || return 1
  clean_system_mounts+=("${!#}")
}

# clean_system_remove: unmounts and removes all that was made.
clean_system_remove() {
  local folder
  for folder in "${clean_system_mounts[@]}"; do
    umount "$folder" || return 1 # never remove what is below a mount
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
  local fresh=$clean_system_folder/fresh certificates=/usr/local/share/ca-certificates
  root=$clean_system_folder/$1
  { [ -e "$fresh" ] || debootstrap --variant=minbase bookworm "$fresh" "$MIRROR"; } &&
    cp -a "$fresh" "$root" &&
    cp -L /etc/resolv.conf "$root/etc/resolv.conf" &&
    mkdir -p "$root$certificates" &&
    mount_below -t proc proc "$root/proc" || return 1
  # Where a network inspects what passes, its own certificates are needed.
  if compgen -G "$certificates/*.crt" >/dev/null; then cp -L $certificates/*.crt "$root$certificates/"; fi
}

# inside COMMAND...: runs it in $root with a plain environment.
inside() {
  chroot "$root" env -i HOME=/tmp PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive "$@" </dev/null
}

# timed WORDS -- COMMAND...: runs it, prints its seconds, by the clock and of all processors, and the words; ends the
# script if it fails.
timed() {
  local words="" log=$clean_system_folder/log
  while [ "$1" != -- ]; do
    words="$words $1"
    shift
  done
  shift
  local TIMEFORMAT="%0R %0U %0S" seconds status
  { time "$@" >"$log" 2>&1 && status=0 || status=$?; } 2>"$log.time"
  if [ "$status" -ne 0 ]; then
    tail -n 40 "$log" >&2
    echo "$0: failed:$words" >&2
    exit 1
  fi
  read -r -a seconds <"$log.time"
  printf '%6d s %6d s of processors %s\n' "${seconds[0]}" $((seconds[1] + seconds[2])) "$words"
}
