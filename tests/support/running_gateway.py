"""A stanok-gateway in a folder of its own."""
import contextlib
import os
import subprocess


@contextlib.contextmanager
def running_gateway(gateway, folder, daemons, broker, options=(), log=None):
    """`daemons`: sockets by the names of their machines; `broker`: a port, or None."""
    named = [word for name, path in daemons.items() for word in ("--daemon", f"{name}={path}")]
    where = [] if "--broker" in options else ["--broker", f"127.0.0.1:{broker}" if broker else "off"]
    process = subprocess.Popen([gateway, *named, *where, "--topic", "cell", "--rate", "5",
                                "--state", os.path.join(folder, "gateway"), *options],
                               stderr=log or subprocess.DEVNULL)
    try:
        yield process
    finally:
        process.terminate()
        try:
            if process.wait(20) != 0:
                raise RuntimeError(f"the gateway ended with {process.returncode}")
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            raise
