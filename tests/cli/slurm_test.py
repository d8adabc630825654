# SPDX-License-Identifier: Apache-2.0
"""A job on a Slurm cluster of two nodes on this machine: arrays, a lost node, and a task that runs twice at once.

Debian's Slurm allows several slurmd on one host. No cgroup plugin is used, because containers have no usable cgroups.
"""
import os
import pathlib
import re
import shutil
import socket
import subprocess
import time
import unittest

from vug import PROGRAM, VugTest, digest

SCENE = """seed 5
volume rock = level_set(box(size: (6, 4, 6)) - sphere(1.8m), voxel: 20cm)
camera main { eye (-1.2, 0.3, 0.4)  target (1, 0, 0)  fov 70deg }
light lamp = sphere(center: (0.5, 0.6, 0.3), radius: 10cm, radiance: (90, 60, 30))
render main { size 64x40  spp 64 }
"""

CONFIGURATION = """ClusterName=vug
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,sched_min_interval=0,bf_interval=1,batch_sched_delay=0
ReturnToService=2
SlurmdTimeout=10
KillWait=5
JobRequeue=1
RequeueExit=3
SlurmctldPort={port}
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={port1} CPUs=1 RealMemory=4000
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={port2} CPUs=1 RealMemory=4000
PartitionName=p Nodes=n1,n2 Default=YES MaxTime=60 State=UP
"""


def missing():
    """The reason why Slurm cannot run here; empty if it can."""
    programs = [name for name in ("slurmctld", "slurmd", "munged", "mungekey", "sbatch") if not shutil.which(name)]
    if programs:
        return f"not installed: {', '.join(programs)}"
    return "" if os.geteuid() == 0 else "the daemons of several nodes need root"


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


class Cluster:
    """Two nodes and their controller in a folder."""

    def __init__(self, folder):
        self.folder = folder
        folder.mkdir()
        for name in ("state", "spool.n1", "spool.n2"):
            (folder / name).mkdir()
        port, port1, port2 = free_ports(3)
        host = socket.gethostname().split(".")[0]
        configuration = folder / "slurm.conf"
        configuration.write_text(
            CONFIGURATION.format(folder=folder, host=host, port=port, port1=port1, port2=port2))
        self.environment = dict(os.environ, SLURM_CONF=str(configuration))
        self.daemons = {}

    def begin(self):
        folder = self.folder
        subprocess.run(["mungekey", "-c", "-k", folder / "key"], check=True)
        self.daemons["munge"] = self.start("munged", "--foreground", "--force", f"--key-file={folder}/key",
                                           f"--socket={folder}/munge.socket", f"--pid-file={folder}/munge.pid",
                                           f"--log-file={folder}/munge.log", f"--seed-file={folder}/munge.seed")
        self.wait(lambda: (folder / "munge.socket").exists(), "munge")
        self.daemons["controller"] = self.start("slurmctld", "-D")
        for node in ("n1", "n2"):
            self.daemons[node] = self.start("slurmd", "-D", "-N", node)
        self.wait(lambda: self.output("sinfo", "-hN", "-o", "%T").split() == ["idle", "idle"], "two idle nodes")

    def start(self, *command):
        return subprocess.Popen(command, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def output(self, *command):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False).stdout

    @staticmethod
    def wait(condition, what, seconds=120):
        end = time.time() + seconds
        while not condition():
            if time.time() > end:
                raise TimeoutError(f"waited {seconds} s for {what}")
            time.sleep(0.2)

    def stop(self):
        for process in reversed(self.daemons.values()):
            process.terminate()
        for process in self.daemons.values():
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()


@unittest.skipIf(missing(), missing())
class Slurm(VugTest):
    def setUp(self):
        super().setUp()
        self.cluster = Cluster(self.folder / "cluster")
        self.addCleanup(self.cluster.stop)
        try:
            self.cluster.begin()
        except (TimeoutError, subprocess.CalledProcessError) as error:
            self.skipTest(f"Slurm does not start on this machine: {error}")

    def prepare(self):
        self.write("s.vug", SCENE)
        self.expect(0, "render", "s.vug", "-o", "whole.exr")

    def submit(self, chunk):
        self.expect(0, "farm", "plan", "s.vug", "-o", "job", "--parts", 6, "--cores", 1, "--chunk", chunk)
        subprocess.run(["./slurm.sh"], cwd=self.folder / "job", env=self.cluster.environment, check=True,
                       stdout=subprocess.DEVNULL)

    def is_finished(self):
        """Whether the picture exists and no task is left. Slurm delays requeued tasks by two minutes; here they start
        at once."""
        for task in re.findall(r"(\S+) BeginTime", self.cluster.output("squeue", "-h", "-r", "-t", "PD", "-o", "%i %r")):
            self.cluster.output("scontrol", "update", f"JobId={task}", "StartTime=now")
        return (self.folder / "job/s.exr").exists() and not self.cluster.output("squeue", "-h")

    def expect_picture(self):
        picture = self.folder / "job/s.exr"
        try:
            self.cluster.wait(self.is_finished, "the picture", 240)
        except TimeoutError as error:
            logs = [f"{path.name}: {path.read_text(errors='replace')[-600:]}"
                    for path in sorted(pathlib.Path(self.folder).rglob("*.log"))]
            raise AssertionError("\n".join([str(error), self.cluster.output("squeue"), *logs])) from error
        self.assertEqual(digest(picture), digest(self.folder / "whole.exr"))

    def test_arrays_of_chunks_survive_a_lost_node(self):
        self.submit(chunk=2)
        self.cluster.wait(lambda: re.search(r"\d_\d", self.cluster.output("squeue", "-h", "-t", "R", "-w", "n2")),
                          "a task on the second node")
        self.cluster.daemons["n2"].kill()
        self.expect_picture()

    def test_a_requeued_task_runs_twice_at_once(self):
        self.submit(chunk=1)

        def running():
            return re.findall(r"\d+_\d+", self.cluster.output("squeue", "-h", "-r", "-t", "R", "-o", "%i"))
        self.cluster.wait(running, "a running task")
        for task in running():
            self.cluster.output("scontrol", "requeue", task)
        # A ghost of the first task, as an engine leaves it behind when it loses contact.
        ghost = subprocess.Popen([PROGRAM, "farm", "run", "job", "--task", "0"], cwd=self.folder,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.expect_picture()
        self.assertEqual(ghost.wait(), 0)


if __name__ == "__main__":
    unittest.main()
