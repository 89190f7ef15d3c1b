#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The recipes of README for Slurm and GNU parallel, with stand-ins for both that run the tasks beside each other.
#   fake_scheduler.sh PROGRAM ROOT
set -eu
program=$1 root=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir bin
ln -s "$program" bin/contactsim
cat >bin/sbatch <<'END'
#!/bin/sh
# sbatch --array=1-N --wrap COMMAND
last=${1#--array=1-}
for task in $(seq "$last"); do SLURM_ARRAY_TASK_ID=$task sh -c "$3" & done
wait
END
cat >bin/parallel <<'END'
#!/bin/sh
# parallel COMMAND... {} with an argument on each line of standard input
while read -r argument; do sh -c "$(printf '%s ' "$@" | sed "s/{}/$argument/")" & done
wait
END
chmod +x bin/sbatch bin/parallel
PATH=$folder/bin:$PATH
cp "$root/decks/two_blocks.i" "$root/decks/two_blocks.g" .

study="two_blocks.i two_blocks.g -D order=1,2"
n=$(contactsim sweep $study --list | wc -l)
test "$n" -eq 2
sbatch --array=1-"$n" --wrap "contactsim sweep $study -o slurm --array slurm"
test ! -e slurm/study.csv
contactsim sweep $study -o slurm --collect
test "$(grep -c ',done,0,' slurm/study.csv)" -eq 2

contactsim sweep $study --list | cut -f1 | parallel contactsim sweep $study -o beside --array {}
contactsim sweep $study -o beside --collect
test "$(grep -c ',done,0,' beside/study.csv)" -eq 2

# What has not been run shows, and the same command does it.
rm -r beside/order=1
contactsim sweep $study -o beside --collect
grep -q 'order=1,1,not run' beside/study.csv
contactsim sweep $study -o beside | grep -q '2 done (1 of them before), 0 failed'
