#!/usr/bin/env python3
"""A pymodbus client of stanok-drives: switches a drive on and moves it, by the registers of
docs/integrator/drives.md alone.

usage: client.py tcp PORT | rtu DEVICE
"""

import sys
import time

from pymodbus.client import ModbusSerialClient, ModbusTcpClient

UNIT = 1
CONTROL, STATUS = 0, 100
STATE_MASK = 0x6F
OPERATION_ENABLED = 0x27


def client_of(kind, where):
    if kind == "tcp":
        return ModbusTcpClient("127.0.0.1", port=int(where))
    return ModbusSerialClient(where, baudrate=115200, timeout=1)


def words(value):
    return [(value >> 16) & 0xFFFF, value & 0xFFFF]


def signed(high, low):
    value = high << 16 | low
    return value - (1 << 32) if value & (1 << 31) else value


class Drive:
    def __init__(self, client):
        self.client = client
        self.heartbeat = 0
        self.target = self.status()["position"]

    def exchange(self, control_word):
        """Function 16 then 3; the echo must be that of this exchange."""
        self.heartbeat = (self.heartbeat + 1) & 0xFFFF
        block = [control_word, *words(self.target), 0, 0, self.heartbeat]
        answer = self.client.write_registers(CONTROL, block, slave=UNIT)
        assert not answer.isError(), answer
        status = self.status()
        assert status["echo"] == self.heartbeat, status
        return status

    def status(self):
        answer = self.client.read_holding_registers(STATUS, 17, slave=UNIT)
        assert not answer.isError(), answer
        r = answer.registers
        return {"word": r[0], "position": signed(r[1], r[2]), "echo": r[11]}

    def switch_on(self):
        for control_word in (0x06, 0x07, 0x0F):
            status = self.exchange(control_word)
        assert status["word"] & STATE_MASK == OPERATION_ENABLED, hex(status["word"])

    def move(self, increments):
        end = self.target + increments
        while self.target != end:
            self.target += 50 if increments > 0 else -50
            self.exchange(0x0F)
        deadline = time.monotonic() + 60  # the simulated drive moves by the clock of a busy computer
        while time.monotonic() < deadline:
            time.sleep(0.01)
            if self.exchange(0x0F)["position"] == end:
                return
        raise AssertionError(f"stands at {self.status()['position']}, not at {end}")


def main():
    client = client_of(sys.argv[1], sys.argv[2])
    assert client.connect(), "no connection"
    drive = Drive(client)
    drive.switch_on()
    drive.move(5000)
    drive.move(-2500)
    status = drive.exchange(0x06)
    assert status["word"] & STATE_MASK == 0x21, hex(status["word"])
    refused = client.read_holding_registers(30000, 1, slave=UNIT)
    assert refused.isError(), "a register that does not exist was read"
    client.close()
    print(f"pymodbus over {sys.argv[1]}: switched on, moved 5 mm and back 2.5 mm, switched off")


if __name__ == "__main__":
    main()
