#!/usr/bin/env python3
"""stanok-opcua as a second client sees it, which is made from the specification and shares nothing with the library of
the server (specified_client.py): the same nodes, types and values as the client of that library and the protocol have.
What must not be is refused, and the server goes on.

usage: second_client_test.py STANOKD MACHINE_FILE FOLDER_OF_OPCUA [unittest arguments]
exit code 77: node or the packages of npm are not to be had
"""
import datetime
import socket
import struct
import time
import unittest
import urllib.parse
import uuid

from binary_encoding import BUILT_IN, NUMBERS, STRUCTURES, DataValue, ExpandedNodeId, ExtensionObject, LocalizedText, \
    Malformed, NodeId, QualifiedName, Reader, StatusCode, Variant, encoded, structures
from served_machine import MANDATORY_MIN, PATIENCE_S, ROOT, ServedMachine, main
from specified_client import ACCESS_LEVEL, AGGREGATES, CLASS_NAMES, DATA_TYPE, MODE_NONE, NAMESPACES, OBJECTS, RENEW, \
    SERVER, SMALLEST_BUFFER_BYTES, VALUE, Channel, Client, Connection, Refused

UA = "http://opcfoundation.org/UA/"
MACHINERY, STANOK = UA + "Machinery/", "urn:stanok:machines"
# Status and limits of the server, and what it tells of the namespace of OPC 10000-100.
SERVER_STATUS, OPERATION_LIMITS, DEVICES = "i=2256", "i=11704", "ns=2;i=15001"
BUILD_INFO = NodeId(0, 2260)
SILENT = 40  # connections, of at most 25
AT_ONCE = 3  # references in an answer, so that BrowseNext gets the others
# Structures of OPC 10000-5 and 10000-8 and the NodeIds of their encodings, members as the library calls them.
STRUCTURES.update(structures("""
Range: low Double, high Double
EUInformation: namespaceUri String, unitId Int32, displayName LocalizedText, description LocalizedText
BuildInfo: productUri String, manufacturerName String, productName String, softwareVersion String, buildNumber String,
 buildDate DateTime
"""))
GET_ENDPOINTS = NodeId(0, 428)
OBJECT_TYPES = {NodeId(0, 886): "Range", NodeId(0, 889): "EUInformation", NodeId(0, 340): "BuildInfo"}
BEGIN_OF_1970 = datetime.datetime(1970, 1, 1, tzinfo=datetime.timezone.utc)  # 11,644,473,600 s behind 1601
# Examples of OPC 10000-6, clause 5.2.2, and of forms that it describes without one: bytes, type and value.
EXAMPLES = (
    ("00 ca 9a 3b", "Int32", 1_000_000_000),
    ("00 00 d0 c0", "Float", -6.5),
    ("06 00 00 00 e6 b0 b4 42 6f 79", "String", "水Boy"),
    ("ff ff ff ff", "String", None),
    ("91 2b 96 72 75 fa e6 4a 8d 28 b4 04 dc 7d af 63", "Guid", uuid.UUID("72962B91-FA75-4AE6-8D28-B404DC7DAF63")),
    ("00 48", "NodeId", NodeId(0, 72)),
    ("01 05 01 04", "NodeId", NodeId(5, 1025)),
    ("02 01 01 00 00 01 00", "NodeId", NodeId(257, 65536)),
    ("03 01 00 06 00 00 00 48 6f 74 e6 b0 b4", "NodeId", NodeId(1, "Hot水")),
    ("04 02 00 91 2b 96 72 75 fa e6 4a 8d 28 b4 04 dc 7d af 63", "NodeId",
     NodeId(2, uuid.UUID("72962B91-FA75-4AE6-8D28-B404DC7DAF63"))),
    ("05 03 00 02 00 00 00 01 02", "NodeId", NodeId(3, b"\1\2")),
    ("c0 48 01 00 00 00 75 07 00 00 00", "ExpandedNodeId", ExpandedNodeId(NodeId(0, 72), "u", 7)),
    ("00 80 3e d5 de b1 9d 01", "DateTime", BEGIN_OF_1970),
    ("00 00 00 00 00 00 00 00", "DateTime", None),
    ("02 00 01 00 00 00 61", "QualifiedName", QualifiedName(2, "a")),
    ("03 02 00 00 00 65 6e 01 00 00 00 61", "LocalizedText", LocalizedText("en", "a")),
    ("00", "LocalizedText", LocalizedText(None, None)),
    ("01 00 76 03 01 01 00 00 00 07", "ExtensionObject", ExtensionObject(NodeId(0, 886), b"\7")),
    ("00 00 00", "ExtensionObject", ExtensionObject(NodeId(0, 0), None)),
    ("00", "Variant", Variant("Null", None, False, None)),
    ("01 01", "Variant", Variant("Boolean", True, False, None)),
    ("c4 04 00 00 00 01 00 02 00 03 00 ff ff 02 00 00 00 02 00 00 00 02 00 00 00", "Variant",
     Variant("Int16", [1, 2, 3, -1], True, [2, 2])),
    ("0d 03 ff 00 80 3e d5 de b1 9d 01 00 00 00 00 00 00 00 00", "DataValue",
     DataValue(Variant("Byte", 255, False, None), StatusCode(0), BEGIN_OF_1970, None)),
    ("3e 00 00 34 80 00 80 3e d5 de b1 9d 01 05 00 00 80 3e d5 de b1 9d 01 06 00", "DataValue",
     DataValue(None, StatusCode(0x80340000), BEGIN_OF_1970, BEGIN_OF_1970)),
    ("45 01 00 00 00 02 00 00 00 00", "DiagnosticInfo", [1, None, None, 2, None, None, [None] * 7]),
)
WRONG = (
    ("05 00 00 00 61", "String"),  # shorter than its length
    ("01 00 00 00 ff", "String"),  # no UTF-8
    ("06 00", "NodeId"),  # form without a meaning
    ("1a 00", "Variant"),  # built-in type that is none
    ("84 ff ff ff 7f", "Variant"),  # elements beyond the end
    ("18" * 200 + "00", "Variant"),  # nested without bound
    ("04", "LocalizedText"),  # undefined bit
)


def node_id_of(text):
    """Of "i=2256" or "ns=8;s=mill"."""
    namespace, _, rest = text.rpartition(";")
    return NodeId(int(namespace.removeprefix("ns=") or 0), int(rest[2:]) if rest.startswith("i=") else rest[2:])


def as_text(node_id):
    return f"ns={node_id.namespace};{node_id.letter}={node_id.identifier}"


def as_json(value):
    """As the library writes it when it makes JSON of something."""
    if isinstance(value, list):
        return [as_json(element) for element in value]
    if isinstance(value, LocalizedText):
        return {name: part for name, part in value._asdict().items() if part is not None}
    if isinstance(value, ExtensionObject) and value.type_id in OBJECT_TYPES:
        members = vars(Reader(value.body).read_all(OBJECT_TYPES[value.type_id]))
        return {name: as_json(member) for name, member in members.items()}
    if isinstance(value, datetime.datetime):
        return value.isoformat(timespec="milliseconds").replace("+00:00", "Z")
    return value


def plain(variant):
    """As client.js tells a value; arrays of numbers are typed arrays there."""
    if variant and variant.is_array and variant.value is not None and variant.type_name in NUMBERS:
        return {str(k): element for k, element in enumerate(variant.value)}
    if variant is None or variant.value is None:
        return "1601-01-01T00:00:00.000Z" if variant and variant.type_name == "DateTime" else None
    if isinstance(variant.value, LocalizedText):
        return variant.value.text or ""
    return as_text(variant.value) if isinstance(variant.value, NodeId) else as_json(variant.value)


class Tree:
    """What client.js answers to "tree", from the other client. `sent_as`: the Variant of each value, by its path."""

    def __init__(self, client):
        self.client, self.namespaces, self.sent_as = client, client.namespaces(), {}

    def ask(self, tree):
        found, ways = {}, [("", node_id_of(tree))]
        while ways:
            way, node_id = ways.pop()
            for reference in self.client.browse(node_id, AGGREGATES, AT_ONCE):
                path, node = way + reference.browse_name.name, self.described(reference)
                found[path] = node
                if node["class"] != "Method":
                    ways.append((path + "/", reference.node_id.node_id))
        self.read_values(found)
        return found

    def named(self, node_id):
        return {"uri": self.namespaces[node_id.namespace], "id": f"{node_id.letter}={node_id.identifier}"}

    def described(self, reference):
        return {"node": as_text(reference.node_id.node_id), "class": CLASS_NAMES[reference.node_class],
                "uri": self.namespaces[reference.browse_name.namespace],
                "type": self.named(reference.type_definition.node_id)}

    def read_values(self, found):
        """Of all variables at once: a request and a response of many chunks."""
        variables = [path for path, node in found.items() if node["class"] == "Variable"]
        values = iter(self.client.read([(node_id_of(found[path]["node"]), attribute) for path in variables
                                        for attribute in (VALUE, DATA_TYPE, ACCESS_LEVEL)]))
        for path, value, data_type, access in zip(variables, values, values, values):
            self.sent_as[path] = value.value
            found[path] |= {"value": plain(value.value), "status": str(value.status),
                            "data_type": self.named(data_type.value.value), "access": access.value.value}


def request_of(channel, /, **other):
    """A GetEndpoints request in one chunk; `other` kind, service or members of headers instead of the right ones."""
    body = encoded("NodeId", other.get("service", GET_ENDPOINTS)) + encoded("RequestHeader", {"request_handle": 1}) + \
        encoded("String", channel.connection.url) + encoded("String[]") * 2
    headers = encoded("SymmetricHeader", {"channel_id": other.get("channel_id", channel.channel_id),
                                          "token_id": other.get("token_id", channel.token_id)}) + \
        encoded("SequenceHeader", {"sequence_number": other.get("sequence", next(channel.sequence)),
                                   "request_id": next(channel.requests)})
    return chunk(other.get("kind", b"MSGF"), headers + body)


def chunk(kind, data=b"", size=None):
    return kind + struct.pack("<I", 8 + len(data) if size is None else size) + data


class BinaryEncoding(unittest.TestCase):
    def test_the_encoding_is_that_of_the_examples(self):
        for text, name, value in EXAMPLES:
            with self.subTest(name, bytes=text):
                self.assertEqual(Reader(bytes.fromhex(text)).read_all(name), value)
                if name in ("Int32", "Float", "String", "DateTime", "NodeId", "QualifiedName", "LocalizedText",
                            "ExtensionObject"):
                    self.assertEqual(encoded(name, value), bytes.fromhex(text))
        for text, name in WRONG:
            with self.subTest(name, bytes=text), self.assertRaises(Malformed):
                Reader(bytes.fromhex(text)).read_all(name)


class SecondClient(ServedMachine):
    def second(self, server, buffer_bytes=SMALLEST_BUFFER_BYTES):
        return self.stack.enter_context(Client(server.address, buffer_bytes))

    def assert_sent_as_declared(self, nodes, sent_as):
        """The built-in type of each value is the one of its data type (OPC 10000-3, 5.8)."""
        enumeration = (UA, "i=29")
        for path, variant in sent_as.items():
            declared = (nodes[path]["data_type"]["uri"], nodes[path]["data_type"]["id"])
            if variant is None or variant.type_name == "Null":
                self.assertTrue(nodes[path]["status"].startswith("Bad"), f"{path}: nothing, and it is Good")
            elif self.types.is_a(declared, enumeration):
                self.assertEqual(variant.type_name, "Int32", path)
            else:
                sent = (UA, f"i={BUILT_IN.index(variant.type_name)}")
                self.assertTrue(self.types.is_a(declared, sent), f"{path}: {declared} sent as {variant.type_name}")

    def test_both_clients_see_the_same(self):
        server = self.server()
        machine, client, second = self.machine, self.client(server), self.second(server)
        tree = Tree(second)
        machine.insist("machine.on")
        machine.ask("override.feed", percent=80)
        machine.ask("program.run", program="long.nc")
        machine.until(lambda status: status["position"]["X"] > 0.5)
        machine.ask("program.hold")
        machine.until(lambda status: status["state"] == "Interrupted" and status["speed_mm_s"] == 0.0)
        state = "Production/ActiveProgram/State/CurrentState"
        nodes = self.assert_equal_to_protocol(tree, "interrupted", lambda found: found[state]["value"] == "Interrupted")
        self.assertGreater(nodes["Monitoring/AxisX/Position"]["value"], 0.0)
        self.assertGreater(self.assert_mandatory_nodes(nodes), MANDATORY_MIN)
        self.assert_sent_as_declared(nodes, tree.sent_as)
        self.assertEqual(nodes, client.ask(tree=ROOT))
        way = (QualifiedName(tree.namespaces.index(MACHINERY), "Machines"),
               QualifiedName(tree.namespaces.index(STANOK), "mill"))
        self.assertEqual(as_text(second.translate(OBJECTS, *way)), ROOT)
        for root in (SERVER_STATUS, OPERATION_LIMITS, DEVICES):  # times, arrays, structures, numbers of several sizes
            ours, theirs = tree.ask(root), client.ask(tree=root)
            for found in (ours, theirs):
                found.pop("CurrentTime", None)
            self.assertEqual(ours, theirs)
        build, version = second.read([(BUILD_INFO, VALUE)])[0].value.value, machine.ask("system.info")["version"]
        build = Reader(build.body).read_all(OBJECT_TYPES[build.type_id])
        self.assertEqual((build.productName, build.productUri, build.softwareVersion),
                         ("stanok-opcua", "urn:stanok:opcua", version))
        self.assertEqual({endpoint.server.product_uri for endpoint in second.endpoints}, {"urn:stanok:opcua"})
        # Requests and responses of several chunks.
        self.assertEqual({tuple(value.value.value) for value in second.read([(NAMESPACES, VALUE)] * 500)},
                         {tuple(tree.namespaces)})
        self.assertGreater(second.channel.chunks_sent, 1)
        self.assertGreater(second.channel.chunks_received, 10)
        variables = sum(node["class"] == "Variable" for node in nodes.values())
        print(f"{len(nodes)} nodes, {variables} of them variables: the same with both clients")

    def refused(self, what, action):
        with self.subTest(what), self.assertRaises(Refused) as caught:
            action()
        return str(caught.exception.status)

    def test_what_is_not_there_is_refused_by_its_name(self):
        server = self.server()
        second, unknown = self.second(server), NodeId(8, "mill-Nothing")
        values = second.read([(unknown, VALUE), (NodeId(77, 1), VALUE), (SERVER, VALUE), (SERVER, 99)])
        self.assertEqual([str(value.status) for value in values],
                         ["BadNodeIdUnknown", "BadNodeIdUnknown", "BadAttributeIdInvalid", "BadAttributeIdInvalid"])
        self.assertEqual([value.value for value in values], [None] * 4)
        [result] = second.request("BrowseNext", continuation_points=[b"nothing"]).results
        self.assertEqual(str(result.status_code), "BadContinuationPointInvalid")
        read = {"nodes_to_read": [{"node_id": SERVER, "attribute_id": VALUE}]}
        self.assertEqual({
            "browse": self.refused("browse", lambda: second.browse(unknown)),
            "way": self.refused("way", lambda: second.translate(OBJECTS, QualifiedName(0, "nothing"))),
            "nothing": self.refused("nothing", lambda: second.read([])),
            "much": self.refused("much", lambda: second.read([(SERVER, VALUE)] * 5001)),
            "session": self.refused("session", lambda: second.channel.request("Read", NodeId(0, b"another"), **read)),
            "no session": self.refused("no session", lambda: second.channel.request("Read", **read)),
        }, {"browse": "BadNodeIdUnknown", "way": "BadNoMatch", "nothing": "BadNothingToDo",
            "much": "BadTooManyOperations", "session": "BadSessionIdInvalid", "no session": "BadSessionIdInvalid"})
        # A new token of the channel, and the session goes on with it.
        token = second.channel.token_id
        second.channel.open(RENEW)
        self.assertNotEqual(second.channel.token_id, token)
        self.assertEqual(second.namespaces()[0], UA)
        self.assertEqual({endpoint.security_mode for endpoint in second.endpoints}, {MODE_NONE, 2, 3})

    def reaction(self, connection, data):
        """Status of the ERR message, or "closed", that follows these bytes. No answer at all, or another one, fails."""
        with connection.socket:
            try:
                connection.socket.sendall(data)
                kind, _ = connection.receive()
            except Refused as refused:
                return str(refused.status)
            except ConnectionError:
                return "closed"
        return self.fail(f"{kind} is the answer to {data[:40]}")

    def test_wrong_messages_end_their_connection_alone(self):
        server = self.server()
        before, address = self.second(server), server.address
        large = before.channel.connection.limits.receive_buffer_size + 1
        policy = encoded("AsymmetricHeader", {"policy_uri": "urn:nothing"})
        seen = {what: self.reaction(Connection(address, SMALLEST_BUFFER_BYTES), data) for what, data in {
            "bytes of another protocol": b"GET / HTTP/1.1\r\n\r\n" * 10,
            "bytes of all values": bytes(range(256)) * 40,
            "a chunk above the buffer": chunk(b"OPNF", b"x" * (large - 8)),
            "a chunk of 4 GiB": chunk(b"OPNF", size=2**32 - 1),
            "chunks of 0 bytes": chunk(b"OPNF", size=0) * 100,
            "Hello again": chunk(b"HELF", encoded("Hello", {"endpoint_url": address})),
            "a request without a channel": chunk(b"MSGF", bytes(40)),
            "an unknown policy": chunk(b"OPNF", policy + bytes(40)),
        }.items()}
        in_channel = {
            "another channel": lambda channel: request_of(channel, channel_id=channel.channel_id + 1000),
            "another token": lambda channel: request_of(channel, token_id=channel.token_id + 1000),
            "a sequence number again": lambda channel: request_of(channel, sequence=1),
            "a sequence number too far": lambda channel: request_of(channel, sequence=1000),
            "a large chunk in a channel": lambda _: chunk(b"MSGF", b"x" * (large - 8)),
            "chunks without end": lambda channel: b"".join(
                request_of(channel, kind=b"MSGC") for _ in range(channel.connection.limits.max_chunk_count + 1)),
            "a service that is none": lambda channel: request_of(channel, service=NodeId(0, 9999)),
        }
        for what, data_for in in_channel.items():
            channel = Channel(address, SMALLEST_BUFFER_BYTES)
            seen[what] = self.reaction(channel.connection, data_for(channel))
        for what, status in seen.items():
            self.assertNotEqual(status, "Good", what)
        for what in ("a chunk above the buffer", "a chunk of 4 GiB", "a large chunk in a channel"):
            self.assertIn(seen[what], ("BadTcpMessageTooLarge", "closed"), what)
        self.assertEqual(before.namespaces(), self.second(server).namespaces())
        print(seen)
        # More connections that say nothing than there are places: the newcomer gets one of them.
        place = urllib.parse.urlsplit(address)
        for _ in range(SILENT):
            self.stack.enter_context(socket.create_connection((place.hostname, place.port)))
        self.assertEqual(before.namespaces(), self.newcomer(server).namespaces())

    def newcomer(self, server):
        """Refused at once now and then, while the server closes an older connection for this one."""
        end = time.monotonic() + PATIENCE_S
        while True:
            try:
                return self.second(server)
            except ConnectionError:
                if time.monotonic() > end:
                    raise
                time.sleep(0.05)


if __name__ == "__main__":
    main()
