"""A server of PostgreSQL in a folder of its own, on a socket of Unix, as a user without rights."""
import glob
import os
import pwd
import shutil
import subprocess
import time


class Postgres:
    def __init__(self, folder):
        self.folder = os.path.join(folder, "postgres")
        self.data = os.path.join(self.folder, "data")
        os.mkdir(self.folder)
        self.programs = sorted(glob.glob("/usr/lib/postgresql/*/bin"))[-1]
        # The server refuses to run as root.
        self.user = "nobody" if os.geteuid() == 0 else pwd.getpwuid(os.geteuid()).pw_name
        if os.geteuid() == 0:
            os.chmod(folder, 0o755)
            shutil.chown(self.folder, self.user)
        self.run("initdb", "-D", self.data, "-U", "cell", "--auth=trust", "-E", "UTF8", "--no-sync")
        self.address = f"postgresql:///postgres?host={self.folder}&user=cell"
        self.start()

    def run(self, name, *words):
        as_user = ["setpriv", "--reuid", self.user, "--regid", str(pwd.getpwnam(self.user).pw_gid), "--clear-groups"]
        command = [os.path.join(self.programs, name), *words]
        subprocess.run([*as_user, *command] if os.geteuid() == 0 else command, check=True, cwd=self.folder,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def control(self, *words):
        self.run("pg_ctl", "-D", self.data, "-w", "-t", "60", *words)

    def start(self):
        self.control("-l", os.path.join(self.folder, "log"), "-o", f"-c listen_addresses='' -k {self.folder}", "start")

    def kill(self):
        """As a loss of power does it: without a checkpoint."""
        self.control("-m", "immediate", "stop")

    def end(self):
        self.control("-m", "fast", "stop")


def wait_until(condition, what, patience_s=60):
    end = time.monotonic() + patience_s
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f"never {what}")
        time.sleep(0.05)
