#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the Debian packages in a bare Debian 12, runs a deck on every level of the processor, then on two ranks, uses what
# else they bring, and removes them without a trace. As root; needs mmdebstrap.
#   tests/package/deb_in_chroot.sh contactsim_0.1.0_amd64.deb contactsim-mpi_0.1.0_amd64.deb
set -euo pipefail
package=$(realpath "$1")
mpi_package=$(realpath "$2")
root=$(mktemp -d)
end() { umount "$root/proc" 2>/dev/null || true; rm -rf --one-file-system "$root"; }
trap end EXIT
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Codename: bookworm' | head -1)
mmdebstrap --quiet --variant=apt --skip=cleanup/apt bookworm "$root" "${mirror:-http://deb.debian.org/debian}"

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@"; }
fail() { echo "deb_in_chroot.sh: $1" >&2; exit 1; }

cp "$package" "$root/tmp/contactsim.deb"
cp "$mpi_package" "$root/tmp/contactsim-mpi.deb"
inside apt-get update -qq
inside apt-get install -y -qq --no-install-recommends python3 python3-numpy man-db groff-base bash-completion >/dev/null
inside apt-get install -y -qq --no-install-recommends /tmp/contactsim.deb 2>&1 | grep -v '^debconf\|^N: ' | tail -3
inside contactsim --version
levels=(x86-64-v2)
supported=$(inside /lib64/ld-linux-x86-64.so.2 --help)
for level in x86-64-v3 x86-64-v4; do
  [[ $supported == *"$level (supported"* ]] && levels+=("$level")
done
for program in "$root"/usr/bin/contactsim "$root"/usr/libexec/contactsim/*; do
  [[ $(readelf -hW "$program") == *"DYN (Position-Independent"* ]] || fail "$program is not position-independent"
  [[ $(readelf -lW "$program") == *GNU_RELRO* ]] || fail "relocations of $program can be written"
  [[ $(readelf -dW "$program") == *NOW* ]] || fail "$program binds late"
done
for program in "$root"/usr/libexec/contactsim/*; do
  symbols=$(readelf -sW --dyn-syms "$program")
  [[ $symbols == *__stack_chk_fail* && $symbols == *_chk@* ]] || fail "stacks or copies of $program are not guarded"
done
mkdir "$root/tmp/run"
cp "$root"/usr/share/contactsim/impact.* "$root/tmp/run"
for level in "${levels[@]}" ""; do
  inside sh -c "cd /tmp/run && ${level:+CONTACTSIM_LEVEL=$level} contactsim impact.i --quiet --summary '$level.json' 2>/dev/null" ||
    fail "the run at level '$level' ends with $?"
  inside grep -q '"state": "done"' "/tmp/run/$level.json" || fail "the run at level '$level' is not done"
done
last=${levels[-1]}
diff <(sed -n '/"energies"/,/}/p' "$root/tmp/run/$last.json") <(sed -n '/"energies"/,/}/p' "$root/tmp/run/.json") ||
  fail "without CONTACTSIM_LEVEL it is not $last that runs"
inside python3 -c 'import contactsim; run = contactsim.Simulation("/usr/share/contactsim/impact.i",
  "/usr/share/contactsim/impact.g", output="/tmp/run/p.e"); run.run(until=1e-6); print(contactsim.__version__, run.time)'
mount -t proc proc "$root/proc"
on_ranks() { inside sh -c "cd /tmp/run && mpirun --allow-run-as-root --oversubscribe -np 2 contactsim impact.i --quiet" 2>&1; }
said=$(inside sh -c 'cd /tmp/run && OMPI_COMM_WORLD_SIZE=2 contactsim impact.i' 2>&1) && fail "it runs on ranks without contactsim-mpi"
[[ $said == *"the package contactsim-mpi is not installed"* ]] || fail "without contactsim-mpi it says: $said"
cp "$root/tmp/run/impact.csv" "$root/tmp/of_one.csv"
inside apt-get install -y -qq --no-install-recommends /tmp/contactsim-mpi.deb >/dev/null 2>&1 || fail "contactsim-mpi cannot be installed"
on_ranks || fail "the run on two ranks ends with $?"
grep -q '2 ranks' "$root/tmp/run/impact.log" || fail "the log does not tell of ranks"
cmp "$root/tmp/run/impact.csv" "$root/tmp/of_one.csv" || fail "two ranks write other results"
umount "$root/proc"
inside dpkg --purge contactsim-mpi >/dev/null 2>&1 || fail "contactsim-mpi cannot be removed"
inside sh -c 'man --warnings contactsim && man --warnings contactsim-deck' >/dev/null 2>"$root/tmp/warnings" || fail "no man page"
[ -s "$root/tmp/warnings" ] && fail "man warns: $(cat "$root/tmp/warnings")"
for file in bash-completion/completions/contactsim zsh/vendor-completions/_contactsim \
  fish/vendor_completions.d/contactsim.fish vim/vimfiles/syntax/contactsim.vim contactsim/vscode/package.json \
  doc/contactsim/html/index.html doc/contactsim/copyright; do
  [ -s "$root/usr/share/$file" ] || fail "there is no /usr/share/$file"
done
owned=$(inside dpkg -L contactsim | sort)
inside dpkg --purge contactsim >/dev/null 2>&1 || fail "it cannot be removed"
while read -r path; do
  if [ -f "$root$path" ] || { [ -d "$root$path" ] && [[ $path == *contactsim* ]]; }; then
    fail "$path is left"
  fi
done <<<"$owned"
echo "installed, run at ${levels[*]}, removed"
