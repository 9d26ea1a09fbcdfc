# Sourced by tests of batches: a cluster of two computers under Slurm, in namespaces of its own.
#
# The script begins again as root of network, process, mount and host-name namespaces: what it starts
# sees nothing else, is seen by nobody, and ends with it. Key, configuration, state and logs lie in
# $folder. Each computer is a slurmd in a process namespace below, so that end_computer takes all that
# ran there with it, as a power failure would. Where this cannot be, the test fails and says why.
# shellcheck shell=bash

fail() {
  printf 'FAILED: %s\n' "$1" >&2
  if [[ -n ${folder:-} ]]; then
    tail -n 20 "$folder"/*.log "$folder"/*.err >&2 || true
  fi
  exit 1
}

export PATH=$PATH:/usr/sbin:/sbin
if [[ ${STANOK_IN_CLUSTER:-no} == no ]]; then
  for tool in unshare ip munged slurmctld slurmd sbatch squeue scancel sinfo scontrol; do
    command -v "$tool" >/dev/null ||
      fail "$tool is not installed: slurmctld, slurmd, slurm-client, munge, iproute2 and util-linux are wanted (tools/install-packages.sh test)"
  done
  ((EUID == 0)) || fail "a cluster in namespaces wants root: munged and slurmd refuse to work for others"
  enter=(unshare --net --uts --mount --pid --fork --kill-child --mount-proc)
  "${enter[@]}" true || fail "unshare is refused: no namespaces for the cluster"
  # Not exec: this one removes the folder, however the cluster ends.
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  STANOK_IN_CLUSTER=yes CLUSTER_FOLDER=$folder "${enter[@]}" "$0" "$@" && code=0 || code=$?
  exit "$code"
fi

folder=$CLUSTER_FOLDER
readonly folder head_address=10.77.0.1 cluster_host=stanok-head
export SLURM_CONF=$folder/slurm.conf

# A dummy interface; where the kernel has none, one end of a pair whose other end is here, too.
make_interface() {
  hostname "$cluster_host"
  ip link set lo up
  ip link add cluster0 type dummy 2>/dev/null || ip link add cluster0 type veth peer name cluster1 ||
    fail "the namespace gets neither a dummy interface nor a veth pair"
  ip link set cluster0 up
  [[ ! -e /sys/class/net/cluster1 ]] || ip link set cluster1 up
  local k
  for k in 1 2 3; do ip addr add "10.77.0.$k/24" dev cluster0; done
}

start_munge() {
  mkdir -p "$folder/munge"
  chmod 755 "$folder"
  (umask 077 && head -c 128 /dev/urandom >"$folder/munge/key")
  munged --force --foreground --origin="$head_address" --key-file="$folder/munge/key" \
    --socket="$folder/munge/socket" --pid-file="$folder/munge/pid" --log-file="$folder/munge.log" \
    --seed-file="$folder/munge/seed" --num-threads=2 2>"$folder/munge.err" &
}

write_configuration() {
  cat >"$SLURM_CONF" <<END
ClusterName=stanok
SlurmctldHost=$cluster_host($head_address)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
# How long a task waits before it begins again, too.
AuthInfo=socket=$folder/munge/socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$folder/controller
SlurmctldPidFile=$folder/controller.pid
SlurmctldLogFile=$folder/controller.log
SlurmdSpoolDir=$folder/%n
SlurmdPidFile=$folder/%n.pid
SlurmdLogFile=$folder/%n.log
MpiDefault=none
SwitchType=switch/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0,bf_interval=1
SlurmdTimeout=3
Prolog=$folder/prolog
BatchStartTimeout=300
ReturnToService=2
MaxJobCount=20000
NodeName=n1 NodeAddr=10.77.0.2 NodeHostname=$cluster_host Port=6818 CPUs=1 State=UNKNOWN
NodeName=n2 NodeAddr=10.77.0.3 NodeHostname=$cluster_host Port=6819 CPUs=1 State=UNKNOWN
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
END
  mkdir -p "$folder/controller" "$folder/n1" "$folder/n2"
  # Runs on a computer before each task.
  cat >"$folder/prolog" <<END
#!/bin/sh
while [ -e "$folder/hold-\$SLURMD_NODENAME" ]; do sleep 0.05; done
END
  chmod 755 "$folder/prolog"
}

# hold_computer NAME: the next task that comes there begins, and goes on with release_computer NAME only.
hold_computer() { touch "$folder/hold-$1"; }
release_computer() { rm -f "$folder/hold-$1"; }

declare -A computers=()

start_computer() {
  # The shell is the first process of the computer: it takes up what tasks leave behind.
  # shellcheck disable=SC2016
  unshare --pid --fork --kill-child --mount-proc bash -c 'slurmd -D -N "$1" & wait' bash "$1" \
    2>>"$folder/$1.err" &
  computers[$1]=$!
}

# Everything that runs there is gone at once.
end_computer() {
  kill -KILL "${computers[$1]}" || fail "computer $1 is lost already"
  wait "${computers[$1]}" 2>/dev/null || true
}

# wait_until WORDS COMMAND...: until the command says yes; fails after two minutes.
wait_until() {
  local -r what=$1
  shift
  local k
  for ((k = 0; k < 2400; ++k)); do
    if "$@" >/dev/null 2>&1; then return; fi
    sleep 0.05
  done
  fail "in vain waited until $what"
}

idle_computers() {
  [[ $(sinfo --noheader --Node --format='%N %t' | grep -c ' idle$') == "$1" ]]
}

start_cluster() {
  make_interface
  start_munge
  wait_until "munged answers" test -S "$folder/munge/socket"
  write_configuration
  slurmctld -D 2>"$folder/controller.err" &
  wait_until "slurmctld answers" sinfo
  start_computer n1
  start_computer n2
  wait_until "both computers are idle" idle_computers 2
}
