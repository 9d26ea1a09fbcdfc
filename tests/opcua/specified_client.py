"""A client of OPC UA that shares nothing with the library of the server: written from the specification, with the
standard library of Python. OPC UA TCP (OPC 10000-6, 7.1 and 7.2), secure conversation (6.7) with security mode None,
and of OPC 10000-4 the services that look. One request at a time; anonymous.

    with Client("opc.tcp://127.0.0.1:4840") as client:
        for reference in client.browse(OBJECTS): ...
        [value] = client.read([(reference.node_id.node_id, VALUE)])     # DataValue

Errors: Refused (the server answers with ERR or with a fault), ConnectionError (it closes the connection), Malformed
(what it sends is not as specified), TimeoutError (no answer within PATIENCE_S).
"""
import datetime
import itertools
import socket
import urllib.parse

from binary_encoding import STRUCTURES, ExtensionObject, LocalizedText, Malformed, NodeId, Reader, StatusCode, \
    encoded, structures

PATIENCE_S = 30
BUFFER_BYTES = 65536  # the largest chunk, either way
SMALLEST_BUFFER_BYTES = 8192  # that a server must take (7.1.2.3)
NO_SECURITY = "http://opcfoundation.org/UA/SecurityPolicy#None"
LIFETIME_MS = 600_000  # of a channel and a session, unless they are renewed or used
ISSUE, RENEW = 0, 1  # SecurityTokenRequestType
MODE_NONE = 1  # MessageSecurityMode
ANONYMOUS = 0  # UserTokenType
ANONYMOUS_TOKEN = NodeId(0, 321)  # encoding of AnonymousIdentityToken
SERVICE_FAULT = NodeId(0, 397)
OBJECTS, SERVER, NAMESPACES = NodeId(0, 85), NodeId(0, 2253), NodeId(0, 2255)
HIERARCHICAL, AGGREGATES = NodeId(0, 33), NodeId(0, 44)  # types of references
VALUE, DATA_TYPE, ACCESS_LEVEL = 13, 14, 17  # attributes (OPC 10000-6, Annex A.1)
BOTH_TIMES = 2  # TimestampsToReturn
CLASS_NAMES = {1: "Object", 2: "Variable", 4: "Method", 8: "ObjectType", 16: "VariableType", 32: "ReferenceType",
               64: "DataType", 128: "View"}

# NodeIds of the binary encodings of request and response (OPC 10000-6, Annex A.3).
SERVICES = {"OpenSecureChannel": (446, 449), "CloseSecureChannel": (452, 455), "CreateSession": (461, 464),
            "ActivateSession": (467, 470), "CloseSession": (473, 476), "Browse": (527, 530), "BrowseNext": (533, 536),
            "TranslateBrowsePathsToNodeIds": (554, 557), "Read": (631, 634)}

# Members as in OPC 10000-6, 7.1.2 and 6.7.2, and in OPC 10000-4; the header of a request or response is not repeated.
STRUCTURES.update(structures("""
Hello: protocol_version UInt32, receive_buffer_size UInt32, send_buffer_size UInt32, max_message_size UInt32,
 max_chunk_count UInt32, endpoint_url String
Acknowledge: protocol_version UInt32, receive_buffer_size UInt32, send_buffer_size UInt32, max_message_size UInt32,
 max_chunk_count UInt32
Error: error StatusCode, reason String
AsymmetricHeader: channel_id UInt32, policy_uri String, certificate ByteString, thumbprint ByteString
SymmetricHeader: channel_id UInt32, token_id UInt32
SequenceHeader: sequence_number UInt32, request_id UInt32
RequestHeader: authentication_token NodeId, timestamp DateTime, request_handle UInt32, return_diagnostics UInt32,
 audit_entry_id String, timeout_hint UInt32, additional_header ExtensionObject
ResponseHeader: timestamp DateTime, request_handle UInt32, service_result StatusCode, diagnostics DiagnosticInfo,
 string_table String[], additional_header ExtensionObject
OpenSecureChannelRequest: client_protocol_version UInt32, request_type Enumeration, security_mode Enumeration,
 client_nonce ByteString, requested_lifetime UInt32
OpenSecureChannelResponse: server_protocol_version UInt32, channel_id UInt32, token_id UInt32, created_at DateTime,
 revised_lifetime UInt32, server_nonce ByteString
CloseSecureChannelRequest:
ApplicationDescription: application_uri String, product_uri String, application_name LocalizedText,
 application_type Enumeration, gateway_server_uri String, discovery_profile_uri String, discovery_urls String[]
UserTokenPolicy: policy_id String, token_type Enumeration, issued_token_type String, issuer_endpoint_url String,
 security_policy_uri String
EndpointDescription: endpoint_url String, server ApplicationDescription, server_certificate ByteString,
 security_mode Enumeration, security_policy_uri String, user_identity_tokens UserTokenPolicy[],
 transport_profile_uri String, security_level Byte
SignedSoftwareCertificate: certificate_data ByteString, signature ByteString
SignatureData: algorithm String, signature ByteString
CreateSessionRequest: client_description ApplicationDescription, server_uri String, endpoint_url String,
 session_name String, client_nonce ByteString, client_certificate ByteString, requested_session_timeout Double,
 max_response_message_size UInt32
CreateSessionResponse: session_id NodeId, authentication_token NodeId, revised_session_timeout Double,
 server_nonce ByteString, server_certificate ByteString, server_endpoints EndpointDescription[],
 server_software_certificates SignedSoftwareCertificate[], server_signature SignatureData,
 max_request_message_size UInt32
ActivateSessionRequest: client_signature SignatureData, client_software_certificates SignedSoftwareCertificate[],
 locale_ids String[], user_identity_token ExtensionObject, user_token_signature SignatureData
ActivateSessionResponse: server_nonce ByteString, results StatusCode[], diagnostic_infos DiagnosticInfo[]
CloseSessionRequest: delete_subscriptions Boolean
CloseSessionResponse:
ViewDescription: view_id NodeId, timestamp DateTime, view_version UInt32
BrowseDescription: node_id NodeId, browse_direction Enumeration, reference_type_id NodeId, include_subtypes Boolean,
 node_class_mask UInt32, result_mask UInt32
ReferenceDescription: reference_type_id NodeId, is_forward Boolean, node_id ExpandedNodeId, browse_name QualifiedName,
 display_name LocalizedText, node_class Enumeration, type_definition ExpandedNodeId
BrowseResult: status_code StatusCode, continuation_point ByteString, references ReferenceDescription[]
BrowseRequest: view ViewDescription, requested_max_references_per_node UInt32, nodes_to_browse BrowseDescription[]
BrowseResponse: results BrowseResult[], diagnostic_infos DiagnosticInfo[]
BrowseNextRequest: release_continuation_points Boolean, continuation_points ByteString[]
BrowseNextResponse: results BrowseResult[], diagnostic_infos DiagnosticInfo[]
RelativePathElement: reference_type_id NodeId, is_inverse Boolean, include_subtypes Boolean, target_name QualifiedName
BrowsePath: starting_node NodeId, elements RelativePathElement[]
BrowsePathTarget: target_id ExpandedNodeId, remaining_path_index UInt32
BrowsePathResult: status_code StatusCode, targets BrowsePathTarget[]
TranslateBrowsePathsToNodeIdsRequest: browse_paths BrowsePath[]
TranslateBrowsePathsToNodeIdsResponse: results BrowsePathResult[], diagnostic_infos DiagnosticInfo[]
ReadValueId: node_id NodeId, attribute_id UInt32, index_range String, data_encoding QualifiedName
ReadRequest: max_age Double, timestamps_to_return Enumeration, nodes_to_read ReadValueId[]
ReadResponse: results DataValue[], diagnostic_infos DiagnosticInfo[]
"""))


class Refused(Exception):
    """The server does not do it. `status`: why, a StatusCode."""

    def __init__(self, status, reason=None):
        super().__init__(f"{status}: {reason}" if reason else str(status))
        self.status = status


class Connection:
    """Messages of OPC UA TCP (7.1.2): Hello and Acknowledge have been exchanged."""

    def __init__(self, url, buffer_bytes=BUFFER_BYTES):
        address = urllib.parse.urlsplit(url)
        self.url, self.buffer_bytes = url, buffer_bytes
        self.socket = socket.create_connection((address.hostname, address.port), PATIENCE_S)
        try:
            self.send(b"HELF", encoded("Hello", {"receive_buffer_size": buffer_bytes, "send_buffer_size": buffer_bytes,
                                                 "endpoint_url": url}))
            kind, data = self.receive()
            if kind != b"ACKF":
                raise Malformed(f"{kind} behind Hello")
            self.limits = Reader(data).read_all("Acknowledge")
            sizes = (self.limits.receive_buffer_size, self.limits.send_buffer_size)
            if not all(SMALLEST_BUFFER_BYTES <= size <= buffer_bytes for size in sizes):
                raise Malformed(f"buffers of {sizes} bytes behind Hello with {buffer_bytes}")
        except BaseException:
            self.socket.close()
            raise

    def send(self, kind, data):
        """`kind`: type of message and of chunk, like b"MSGF"."""
        self.socket.sendall(kind + encoded("UInt32", 8 + len(data)) + data)

    def _take(self, length):
        data = b""
        while len(data) < length:
            part = self.socket.recv(length - len(data))
            if not part:
                raise ConnectionError("the server has closed the connection")
            data += part
        return data

    def receive(self):
        """Type and what stands behind the header of the next chunk."""
        kind = self._take(4)
        size = int.from_bytes(self._take(4), "little")
        if not 8 <= size <= self.buffer_bytes:
            raise Malformed(f"a chunk {kind} of {size} bytes")
        data = self._take(size - 8)
        if kind == b"ERRF":
            error = Reader(data).read_all("Error")
            raise Refused(error.error, error.reason)
        return kind, data


class Channel:
    """A secure channel without security (6.7): requests go out and responses come back in chunks."""

    def __init__(self, url, buffer_bytes=BUFFER_BYTES):
        self.connection = Connection(url, buffer_bytes)
        self.channel_id = self.token_id = self.sequence_received = 0
        self.sequence, self.requests = itertools.count(1), itertools.count(1)
        self.chunks_sent = self.chunks_received = 0  # of the last request and its response
        try:
            self.open(ISSUE)
        except BaseException:
            self.connection.socket.close()
            raise

    def open(self, request_type):
        """A new token; the one before ends as soon as this one is used."""
        response = self.request("OpenSecureChannel", request_type=request_type, security_mode=MODE_NONE,
                                requested_lifetime=LIFETIME_MS)
        self.channel_id, self.token_id = response.channel_id, response.token_id

    def close(self):
        """The server answers by closing the connection (7.1.4)."""
        with self.connection.socket:
            self.send("CloseSecureChannel", {}, next(self.requests))
            try:
                kind, _ = self.connection.receive()
            except ConnectionError:
                return
        raise Malformed(f"{kind} behind CloseSecureChannel")

    def request(self, service, authentication_token=None, **members):
        """The response; Refused when it is a fault or not good. `authentication_token`: of the session."""
        number = next(self.requests)
        self.send(service, members, number, authentication_token)
        return self.response(service, number)

    def send(self, service, members, number, authentication_token=None):
        header = {"authentication_token": authentication_token, "request_handle": number,
                  "timestamp": datetime.datetime.now(datetime.timezone.utc), "timeout_hint": PATIENCE_S * 1000}
        self.send_data(service, number, encoded("NodeId", NodeId(0, SERVICES[service][0])) +
                       encoded("RequestHeader", header) + encoded(service + "Request", members))

    def send_data(self, service, number, data):
        """In as many chunks as the server's buffer wants (6.7.2)."""
        message = {"OpenSecureChannel": b"OPN", "CloseSecureChannel": b"CLO"}.get(service, b"MSG")
        if message == b"OPN":
            security = encoded("AsymmetricHeader", {"channel_id": self.channel_id, "policy_uri": NO_SECURITY})
        else:
            security = encoded("SymmetricHeader", {"channel_id": self.channel_id, "token_id": self.token_id})
        length = self.connection.limits.receive_buffer_size - 8 - len(security) - 8
        parts = [data[at:at + length] for at in range(0, len(data), length)]
        for k, part in enumerate(parts, 1):
            sequence = encoded("SequenceHeader", {"sequence_number": next(self.sequence), "request_id": number})
            self.connection.send(message + (b"F" if k == len(parts) else b"C"), security + sequence + part)
        self.chunks_sent = len(parts)

    def response(self, service, number):
        reader = Reader(self._received(b"OPN" if service == "OpenSecureChannel" else b"MSG", number))
        type_id, header = reader.read("NodeId"), reader.read("ResponseHeader")
        if header.request_handle != number:
            raise Malformed(f"handle {header.request_handle} of the answer to {number}")
        if type_id == SERVICE_FAULT or not header.service_result.is_good:
            raise Refused(header.service_result)
        if type_id != NodeId(0, SERVICES[service][1]):
            raise Malformed(f"{type_id} is no answer to {service}")
        return reader.read_all(service + "Response")

    def _received(self, message, number):
        """The body of a message, from its chunks."""
        body, self.chunks_received, is_last = b"", 0, False
        while not is_last:
            kind, data = self.connection.receive()
            reader = Reader(data)
            security = reader.read("AsymmetricHeader" if kind[:3] == b"OPN" else "SymmetricHeader")
            sequence = reader.read("SequenceHeader")
            self._check(kind, message, security, sequence, number)
            if kind[3:] == b"A":
                error = reader.read_all("Error")
                raise Refused(error.error, error.reason)
            body, is_last = body + reader.take(reader.left), kind[3:] == b"F"
            self.chunks_received += 1
        return body

    def _check(self, kind, message, security, sequence, number):
        if kind[:3] != message or kind[3:] not in (b"F", b"C", b"A") or sequence.request_id != number:
            raise Malformed(f"{kind}, request {sequence.request_id}; {message}, request {number} was awaited")
        if self.channel_id and security.channel_id != self.channel_id:
            raise Malformed(f"channel {security.channel_id} instead of {self.channel_id}")
        if message == b"MSG" and security.token_id != self.token_id:
            raise Malformed(f"token {security.token_id} instead of {self.token_id}")
        if self.sequence_received and sequence.sequence_number != self.sequence_received + 1:
            raise Malformed(f"sequence number {sequence.sequence_number} behind {self.sequence_received}")
        self.sequence_received = sequence.sequence_number


class Client:
    """A session (OPC 10000-4, Session Service Set) of its own channel, as long as the block of `with`."""

    def __init__(self, url, buffer_bytes=BUFFER_BYTES):
        self.channel, self.token = Channel(url, buffer_bytes), None
        try:
            self._begin(url)
        except BaseException:
            self.channel.connection.socket.close()
            raise

    def _begin(self, url):
        description = {"application_uri": "urn:stanok:specified-client", "application_type": 1,
                       "application_name": LocalizedText("en", "client of the specification")}
        created = self.request("CreateSession", client_description=description, endpoint_url=url,
                               session_name="specified", requested_session_timeout=LIFETIME_MS)
        self.token, self.endpoints = created.authentication_token, created.server_endpoints
        policy = next((token.policy_id for endpoint in self.endpoints or [] if endpoint.security_mode == MODE_NONE
                       for token in endpoint.user_identity_tokens or [] if token.token_type == ANONYMOUS), None)
        if policy is None:
            raise Refused(StatusCode(0x80210000), "no endpoint without security and without a user")
        self.request("ActivateSession", user_identity_token=ExtensionObject(ANONYMOUS_TOKEN, encoded("String", policy)))

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        with self.channel.connection.socket:
            if kind is None:
                self.request("CloseSession", delete_subscriptions=True)
                self.channel.close()

    def request(self, service, **members):
        return self.channel.request(service, self.token, **members)

    def browse(self, node_id, reference_type=HIERARCHICAL, at_once=0):
        """References (ReferenceDescription) forward from the node, `at_once` in an answer (0: as many as the server
        wants) and with BrowseNext until it has no more."""
        wanted = {"node_id": node_id, "reference_type_id": reference_type, "include_subtypes": True, "result_mask": 63}
        response = self.request("Browse", requested_max_references_per_node=at_once, nodes_to_browse=[wanted])
        found = []
        while True:
            [result] = response.results
            if not result.status_code.is_good:
                raise Refused(result.status_code)
            found += result.references or []
            if not result.continuation_point:
                return found
            if not result.references or at_once and len(result.references) > at_once:
                raise Malformed(f"{len(result.references or [])} references where {at_once} are wanted at once")
            response = self.request("BrowseNext", continuation_points=[result.continuation_point])

    def read(self, wanted):
        """A DataValue for each (node id, attribute)."""
        nodes = [{"node_id": node_id, "attribute_id": attribute} for node_id, attribute in wanted]
        results = self.request("Read", timestamps_to_return=BOTH_TIMES, nodes_to_read=nodes).results or []
        if len(results) != len(nodes):
            raise Malformed(f"{len(results)} values where {len(nodes)} are wanted")
        return results

    def translate(self, node_id, *names):
        """The node at the end of a way of browse names (QualifiedName); Refused when there is none."""
        way = [{"reference_type_id": HIERARCHICAL, "include_subtypes": True, "target_name": name} for name in names]
        [result] = self.request("TranslateBrowsePathsToNodeIds",
                                browse_paths=[{"starting_node": node_id, "elements": way}]).results
        if not result.status_code.is_good:
            raise Refused(result.status_code)
        return result.targets[0].target_id.node_id

    def namespaces(self):
        return self.read([(NAMESPACES, VALUE)])[0].value.value
