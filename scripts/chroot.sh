# Sourced by the scripts that test in an empty Debian 12: creates one in a folder. Needs root. Packages come from the apt
# sources of this machine.
# shellcheck disable=SC2016 # $(REPO_URI) and its like are apt's

# empty_debian FOLDER: creates a minimal system in FOLDER, for in_chroot, and removes the previous content. The first call takes
# a minute, the next ones unpack build/debian12.tar.
empty_debian() {
    local folder=$1 mirror kept=build/debian12.tar
    if [ "$(id -u)" -ne 0 ]; then
        echo "Run this as root: it creates a system in $folder (debootstrap, chroot)." >&2
        return 1
    fi
    need debootstrap || return 1
    remove_chroot "$folder"
    mkdir -p "$folder" build
    if [ ! -e "$kept" ]; then
        mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Codename: bookworm' | head -n 1)
        if [ -z "$mirror" ]; then
            echo "This machine's apt sources do not have Debian 12 (bookworm)." >&2
            return 1
        fi
        debootstrap --variant=minbase bookworm "$folder" "$mirror" >build/debootstrap.log ||
            { tail build/debootstrap.log >&2; return 1; }
        tar -C "$folder" -cf "$kept.part" . && mv "$kept.part" "$kept"
    else
        tar -C "$folder" -xf "$kept"
    fi
    # All Debian 12 sources of this machine, including updates and security, through the same proxy.
    apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' |
        grep -F ' bookworm' >"$folder/etc/apt/sources.list"
    apt-config dump Acquire >"$folder/etc/apt/apt.conf.d/00machine"
    [ ! -e /etc/apt/auth.conf.d ] || cp -r /etc/apt/auth.conf.d "$folder/etc/apt/"
    printf '#!/bin/sh\nexit 101\n' >"$folder/usr/sbin/policy-rc.d" # no service is started in the chroot
    chmod +x "$folder/usr/sbin/policy-rc.d"
    echo force-unsafe-io >"$folder/etc/dpkg/dpkg.cfg.d/unsafe-io" # faster; the system need not survive a power failure
    cp -L /etc/resolv.conf /etc/hosts "$folder/etc/"
    mount -t proc proc "$folder/proc"
    mount --bind /dev "$folder/dev"
    mount --bind /dev/pts "$folder/dev/pts"
    in_chroot "$folder" apt-get update -qq
}

# in_chroot FOLDER COMMAND...: runs COMMAND in the system, as root, with a clean environment.
in_chroot() {
    local folder=$1
    shift
    env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive TERM="${TERM:-dumb}" \
        ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} chroot "$folder" "$@"
}

# remove_chroot FOLDER: unmounts its file systems and removes it. May be called from a trap.
remove_chroot() {
    local mounted
    [ -d "$1" ] || return 0
    for mounted in dev/pts dev proc; do
        ! mountpoint -q "$1/$mounted" || umount "$1/$mounted" || umount -l "$1/$mounted"
    done
    if mount | grep -qF " on $(realpath "$1")/"; then
        echo "$1 is not removed: a file system is still mounted in it." >&2
        return 1
    fi
    rm -rf --one-file-system "$1"
}
