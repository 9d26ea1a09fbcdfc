#!/usr/bin/env python3
"""A pymodbus server with the three drives and the I/O module of docs/integrator/drives.md.

The drives follow at once: what is written comes back as actual values. The servo (unit 1) runs the
states of CiA 402, the stepper (2) and the inverter (11) their own words. Says on standard output
what happens to the spindle and the coil.

usage: server.py READY_FILE [DEVICE]
Modbus TCP: the port is written into READY_FILE when the server listens; with DEVICE Modbus RTU on
that serial line, and READY_FILE gets its name.
"""

import asyncio
import sys

from pymodbus.datastore import ModbusServerContext, ModbusSlaveContext, ModbusSparseDataBlock
from pymodbus.framer.rtu_framer import ModbusRtuFramer
from pymodbus.server.async_io import ModbusSerialServer, ModbusTcpServer

SERVO, STEPPER, INVERTER, MODULE = 1, 2, 11, 20


def say(text):
    print(text, flush=True)


class Block(ModbusSparseDataBlock):
    """Holding registers of a drive; calls `written` after every write."""

    def __init__(self, ranges, written):
        super().__init__({address: 0 for first, count in ranges for address in range(first, first + count)})
        self.written = written

    def setValues(self, address, values, use_as_default=False):
        super().setValues(address, values)
        self.written(self.values)


def servo_state(word, control_word):
    """Next state word of CiA 402."""
    command = control_word & 0x0F
    if control_word & 0x02 == 0:
        return 0x40
    if command == 0x06:
        return 0x21
    if command in (0x07, 0x0F) and word in (0x21, 0x23, 0x27):
        return 0x27 if command == 0x0F else 0x23
    return word if control_word & 0x04 else 0x40


def servo(values):
    values[0x80] = servo_state(values[0x80], values[0x40])
    for k in (1, 2, 3, 4):
        values[0x80 + k] = values[0x40 + k]


def stepper(values):
    values[0x1000] = 0x0002 if values[0x1800] == 1 else 0
    values[0x1003], values[0x1004] = values[0x1801], values[0x1802]


class Inverter:
    def __init__(self):
        self.seen = None

    def __call__(self, values):
        runs = values[0x2000] in (0x12, 0x22)
        values[0x2101] = 0x0003 if runs else 0
        values[0x2103] = round(0.3 * values[0x2001]) if runs else 0
        values[0x2104] = 4 if runs else 0
        seen = values[0x2001] if runs else 0
        if seen != self.seen and seen in (0, 5000):
            say("spindle stopped" if seen == 0 else f"spindle runs at {0.01 * seen:.2f} Hz")
        self.seen = seen


class Coils(ModbusSparseDataBlock):
    def setValues(self, address, values, use_as_default=False):
        before = dict(self.values)
        super().setValues(address, values)
        if before != self.values:
            say("coil 0 on" if self.values[0] else "coil 0 off")


def slave(ranges, written):
    block = Block(ranges, written)
    return ModbusSlaveContext(hr=block, zero_mode=True)


def context():
    servo_slave = slave([(0x40, 5), (0x80, 9)], servo)
    servo_slave.store["h"].values[0x80] = 0x40
    module = ModbusSlaveContext(
        co=Coils({k: False for k in range(16)}),
        di=ModbusSparseDataBlock({k: False for k in range(16)}),
        zero_mode=True,
    )
    return ModbusServerContext(
        slaves={
            SERVO: servo_slave,
            STEPPER: slave([(0x1000, 5), (0x1800, 4)], stepper),
            INVERTER: slave([(0x2000, 2), (0x2101, 4)], Inverter()),
            MODULE: module,
        },
        single=False,
    )


def tell(ready):
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(ready)


async def serve_line(device):
    server = ModbusSerialServer(context(), framer=ModbusRtuFramer, port=device, baudrate=115200)
    await server.start()
    tell(device)
    await server.serve_forever()


async def serve_network():
    server = ModbusTcpServer(context(), address=("127.0.0.1", 0))
    serving = asyncio.ensure_future(server.serve_forever())
    await server.serving
    tell(str(server.server.sockets[0].getsockname()[1]))
    await serving


async def main():
    if len(sys.argv) > 2:
        await serve_line(sys.argv[2])
    else:
        await serve_network()


if __name__ == "__main__":
    asyncio.run(main())
