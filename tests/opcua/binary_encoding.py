"""The binary encoding of OPC UA (OPC 10000-6, clause 5.2), written from the specification alone.

    encoded("NodeId", NodeId(8, "mill"))            # bytes
    Reader(data).read("Variant")                    # a value; Malformed when the bytes are none

Types are named as in the specification; "String[]" is an array. A structure is a table of its members (STRUCTURES): it
is read as an object with these attributes and written from a dictionary; what the dictionary leaves out is null or 0.
"""
import datetime
import struct
import types
import typing
import uuid

NUMBERS = {"Boolean": "?", "SByte": "b", "Byte": "B", "Int16": "h", "UInt16": "H", "Int32": "i", "UInt32": "I",
           "Int64": "q", "UInt64": "Q", "Float": "f", "Double": "d", "Enumeration": "i"}  # 5.2.2.1 to 5.2.2.3, 5.2.4
BUILT_IN = ("Null", "Boolean", "SByte", "Byte", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64", "Float",
            "Double", "String", "DateTime", "Guid", "ByteString", "XmlElement", "NodeId", "ExpandedNodeId",
            "StatusCode", "QualifiedName", "LocalizedText", "ExtensionObject", "DataValue", "Variant",
            "DiagnosticInfo")  # 5.1.2
EPOCH = datetime.datetime(1601, 1, 1, tzinfo=datetime.timezone.utc)  # of DateTime, in steps of 100 ns (5.2.2.5)
LAST_TIME = datetime.datetime(9999, 12, 31, 23, 59, 59, tzinfo=datetime.timezone.utc)
NESTING_MAX = 100  # of variants and diagnostic infos: what every decoder must bear (5.2.2.12, 5.2.2.16)
# Of those in OPC 10000-6, Annex A.2, the ones that servers of machines answer with.
STATUS_NAMES = {
    0x80010000: "BadUnexpectedError", 0x80020000: "BadInternalError", 0x80050000: "BadCommunicationError",
    0x80070000: "BadDecodingError", 0x800A0000: "BadTimeout", 0x800B0000: "BadServiceUnsupported",
    0x800F0000: "BadNothingToDo", 0x80100000: "BadTooManyOperations", 0x80130000: "BadSecurityChecksFailed",
    0x801F0000: "BadUserAccessDenied", 0x80210000: "BadIdentityTokenRejected", 0x80220000: "BadSecureChannelIdInvalid",
    0x80250000: "BadSessionIdInvalid", 0x80260000: "BadSessionClosed", 0x80270000: "BadSessionNotActivated",
    0x80310000: "BadNoCommunication", 0x80320000: "BadWaitingForInitialData", 0x80330000: "BadNodeIdInvalid",
    0x80340000: "BadNodeIdUnknown", 0x80350000: "BadAttributeIdInvalid", 0x803D0000: "BadNotSupported",
    0x804A0000: "BadContinuationPointInvalid", 0x806F0000: "BadNoMatch", 0x807D0000: "BadTcpServerTooBusy",
    0x807E0000: "BadTcpMessageTypeInvalid", 0x807F0000: "BadTcpSecureChannelUnknown",
    0x80800000: "BadTcpMessageTooLarge", 0x80820000: "BadTcpInternalError", 0x80880000: "BadSequenceNumberInvalid",
    0x809B0000: "BadNoData", 0x80AC0000: "BadConnectionRejected", 0x80B80000: "BadRequestTooLarge",
    0x80B90000: "BadResponseTooLarge", 0x80E60000: "BadSecurityModeInsufficient",
}


class Malformed(Exception):
    """What was received is not what the specification describes."""


class StatusCode(int):
    """Good when its two highest bits are 0 (OPC 10000-4, StatusCode); the lower 16 are flags without a name."""

    @property
    def is_good(self):
        return self >> 30 == 0

    def __str__(self):
        return "Good" if self.is_good else STATUS_NAMES.get(self & 0xFFFF0000, f"0x{int(self):08X}")


class NodeId(typing.NamedTuple):
    namespace: int
    identifier: int | str | uuid.UUID | bytes

    @property
    def letter(self):
        return {int: "i", str: "s", uuid.UUID: "g", bytes: "b"}[type(self.identifier)]


class ExpandedNodeId(typing.NamedTuple):
    node_id: NodeId
    namespace_uri: str | None
    server_index: int


class QualifiedName(typing.NamedTuple):
    namespace: int
    name: str | None


class LocalizedText(typing.NamedTuple):
    locale: str | None
    text: str | None


class ExtensionObject(typing.NamedTuple):
    type_id: NodeId  # of the encoding; i=0 and no body where there is no object
    body: bytes | None


class Variant(typing.NamedTuple):
    type_name: str  # one of BUILT_IN
    value: object  # a list, flat, where it is an array
    is_array: bool
    dimensions: list[int] | None


class DataValue(typing.NamedTuple):
    value: Variant | None
    status: StatusCode
    source_time: datetime.datetime | None
    server_time: datetime.datetime | None


def structures(text):
    """The members, [(name, type)], of each line "Structure: name Type, ..."; a line that begins with blanks goes on."""
    lines = text.strip().replace("\n ", " ").splitlines()
    return {name: [tuple(member.split()) for member in members.split(",") if member.strip()]
            for name, _, members in (line.partition(":") for line in lines)}


STRUCTURES = {}  # those that are known, by name


class Reader:
    """Reads values from bytes, one behind the other. Whatever is wrong with them is Malformed."""

    def __init__(self, data):
        self.data, self.at, self.depth = data, 0, 0

    @property
    def left(self):
        return len(self.data) - self.at

    def take(self, length):
        if length > self.left:
            raise Malformed(f"{length} bytes wanted at {self.at}, {self.left} are left")
        self.at += length
        return self.data[self.at - length:self.at]

    def read(self, type_name):
        if type_name.endswith("[]"):
            return self.array(type_name.removesuffix("[]"))
        if type_name in NUMBERS:
            form = "<" + NUMBERS[type_name]
            return struct.unpack(form, self.take(struct.calcsize(form)))[0]
        if type_name in STRUCTURES:
            return types.SimpleNamespace(**{name: self.read(kind) for name, kind in STRUCTURES[type_name]})
        return READERS[type_name](self)

    def read_all(self, type_name):
        """The value that takes all bytes."""
        value = self.read(type_name)
        if self.left:
            raise Malformed(f"{self.left} bytes behind a {type_name}")
        return value

    def array(self, type_name):
        """5.2.5. No element takes less than a byte."""
        length = self.read("Int32")
        if length > self.left:
            raise Malformed(f"{length} elements of {type_name} in {self.left} bytes")
        return None if length < 0 else [self.read(type_name) for _ in range(length)]

    def byte_string(self):
        length = self.read("Int32")
        return None if length < 0 else self.take(length)

    def string(self):
        data = self.byte_string()
        try:
            return None if data is None else data.decode("utf-8")
        except UnicodeDecodeError as error:
            raise Malformed(str(error)) from error

    def date_time(self):
        """To the microsecond; none for 0, the earliest time there is."""
        steps = self.read("Int64")
        if steps <= 0:
            return None
        try:
            return EPOCH + datetime.timedelta(microseconds=steps // 10)
        except OverflowError:
            return LAST_TIME

    def guid(self):
        return uuid.UUID(bytes_le=self.take(16))

    def status_code(self):
        return StatusCode(self.read("UInt32"))

    def flags(self, known):
        """A byte of which only these bits are defined."""
        mask = self.read("Byte")
        if mask & ~known:
            raise Malformed(f"bits 0x{mask:02X}, of which 0x{known:02X} are defined")
        return mask

    def node_id(self, form=None):
        """5.2.2.9."""
        form = self.read("Byte") if form is None else form
        numeric = {0: (None, "Byte"), 1: ("Byte", "UInt16"), 2: ("UInt16", "UInt32")}
        if form in numeric:
            namespace, number = numeric[form]
            return NodeId(self.read(namespace) if namespace else 0, self.read(number))
        if form not in (3, 4, 5):
            raise Malformed(f"form {form} of a node id")
        return NodeId(self.read("UInt16"), self.read(("String", "Guid", "ByteString")[form - 3]))

    def expanded_node_id(self):
        form = self.read("Byte")
        node_id = self.node_id(form & 0x3F)
        uri = self.string() if form & 0x80 else None
        return ExpandedNodeId(node_id, uri, self.read("UInt32") if form & 0x40 else 0)

    def qualified_name(self):
        return QualifiedName(self.read("UInt16"), self.string())

    def localized_text(self):
        mask = self.flags(0x03)
        return LocalizedText(self.string() if mask & 0x01 else None, self.string() if mask & 0x02 else None)

    def extension_object(self):
        type_id, form = self.node_id(), self.read("Byte")
        if form > 2:
            raise Malformed(f"form {form} of an extension object")
        return ExtensionObject(type_id, self.byte_string() if form else None)

    def nested(self, read):
        if self.depth == NESTING_MAX:
            raise Malformed(f"nested {NESTING_MAX} times")
        self.depth += 1
        value = read()
        self.depth -= 1
        return value

    def variant(self):
        """5.2.2.16."""
        mask = self.read("Byte")
        if mask & 0x3F >= len(BUILT_IN):
            raise Malformed(f"built-in type {mask & 0x3F}")
        name = BUILT_IN[mask & 0x3F]
        if name == "Null":
            return Variant(name, None, False, None)
        value = self.nested(lambda: self.array(name) if mask & 0x80 else self.read(name))
        return Variant(name, value, bool(mask & 0x80), self.array("Int32") if mask & 0x40 else None)

    def data_value(self):
        """5.2.2.17. Picoseconds stand behind their times and are left out."""
        mask = self.flags(0x3F)
        value = self.variant() if mask & 0x01 else None
        status = self.status_code() if mask & 0x02 else StatusCode(0)
        times = []
        for time, picoseconds in ((0x04, 0x10), (0x08, 0x20)):
            times.append(self.date_time() if mask & time else None)
            if mask & picoseconds:
                self.read("UInt16")
        return DataValue(value, status, *times)

    def diagnostic_info(self):
        """5.2.2.12, as a list: symbolic id, namespace, locale, text, more information, inner status, inner info."""
        mask = self.flags(0x7F)
        members = ((0x01, "Int32"), (0x02, "Int32"), (0x08, "Int32"), (0x04, "Int32"), (0x10, "String"),
                   (0x20, "StatusCode"), (0x40, "DiagnosticInfo"))
        return self.nested(lambda: [self.read(kind) if mask & bit else None for bit, kind in members])


READERS = {"String": Reader.string, "XmlElement": Reader.string, "ByteString": Reader.byte_string,
           "DateTime": Reader.date_time, "Guid": Reader.guid, "StatusCode": Reader.status_code,
           "NodeId": Reader.node_id, "ExpandedNodeId": Reader.expanded_node_id, "QualifiedName": Reader.qualified_name,
           "LocalizedText": Reader.localized_text, "ExtensionObject": Reader.extension_object,
           "DataValue": Reader.data_value, "Variant": Reader.variant, "DiagnosticInfo": Reader.diagnostic_info}


def encoded(type_name, value=None):
    """The bytes of a value of this type; of None: of its null, which of numbers is 0. KeyError: a type, or a member of
    a structure, that is not known."""
    if type_name.endswith("[]"):
        elements = value or ()
        return encoded("Int32", -1 if value is None else len(elements)) + b"".join(
            encoded(type_name.removesuffix("[]"), element) for element in elements)
    if type_name in NUMBERS:
        return struct.pack("<" + NUMBERS[type_name], value or 0)
    if type_name in STRUCTURES:
        given = dict(value or {})
        data = b"".join(encoded(kind, given.pop(name, None)) for name, kind in STRUCTURES[type_name])
        if given:
            raise KeyError(f"{type_name} has no {', '.join(given)}")
        return data
    return WRITERS[type_name](value)


def byte_string_bytes(value):
    return encoded("Int32", -1) if value is None else encoded("Int32", len(value)) + value


def string_bytes(value):
    return byte_string_bytes(None if value is None else value.encode())


def date_time_bytes(value):
    return encoded("Int64", (value - EPOCH) // datetime.timedelta(microseconds=1) * 10 if value else 0)


def node_id_bytes(value):
    """In the shortest of its forms."""
    namespace, identifier = value or NodeId(0, 0)
    if isinstance(identifier, int):
        if namespace == 0 and identifier < 2**8:
            return struct.pack("<BB", 0, identifier)
        if namespace < 2**8 and identifier < 2**16:
            return struct.pack("<BBH", 1, namespace, identifier)
        return struct.pack("<BHI", 2, namespace, identifier)
    form, data = {str: (3, string_bytes), uuid.UUID: (4, lambda guid: guid.bytes_le),
                  bytes: (5, byte_string_bytes)}[type(identifier)]
    return struct.pack("<BH", form, namespace) + data(identifier)


def qualified_name_bytes(value):
    namespace, name = value or QualifiedName(0, None)
    return encoded("UInt16", namespace) + string_bytes(name)


def localized_text_bytes(value):
    parts = value or LocalizedText(None, None)
    mask = sum(bit for bit, part in zip((0x01, 0x02), parts) if part is not None)
    return encoded("Byte", mask) + b"".join(string_bytes(part) for part in parts if part is not None)


def extension_object_bytes(value):
    type_id, body = value or ExtensionObject(NodeId(0, 0), None)
    return node_id_bytes(type_id) + (b"\0" if body is None else b"\1" + byte_string_bytes(body))


WRITERS = {"String": string_bytes, "ByteString": byte_string_bytes, "DateTime": date_time_bytes,
           "NodeId": node_id_bytes, "QualifiedName": qualified_name_bytes, "LocalizedText": localized_text_bytes,
           "ExtensionObject": extension_object_bytes}
