"""Types of the companion specifications, read from their own files (NodeSet2 of the OPC Foundation).

    types = CompanionTypes(folder)
    types.mandatory(type_id)        # [(namespace, browse name, class, type, data type)] of what an object must have
"""
import os
import re
import xml.etree.ElementTree as ElementTree

UA = "http://opcfoundation.org/UA/"
FILES = ("Opc.Ua.NodeSet2.xml", "Opc.Ua.Di.NodeSet2.xml", "Opc.Ua.Machinery.NodeSet2.xml", "Opc.Ua.IA.NodeSet2.xml",
         "Opc.Ua.MachineTool.NodeSet2.xml", "Opc.Ua.Machinery.Jobs.Nodeset2.xml",
         "opc.ua.isa95-jobcontrol.nodeset2.xml")
SCHEMA = "{http://opcfoundation.org/UA/2011/03/UANodeSet.xsd}"
HAS_SUBTYPE, HAS_TYPE, HAS_RULE = "i=45", "i=40", "i=37"
MANDATORY = "i=78"
PARTS = {"i=46", "i=47", "i=49", "i=17604"}  # HasProperty, HasComponent, HasOrderedComponent, HasAddIn


class Node:
    def __init__(self, element, names, resolve):
        namespace, name = re.fullmatch(r"(?:(\d+):)?(.*)", element.get("BrowseName")).groups()
        self.kind = element.tag.removeprefix(SCHEMA + "UA")
        self.uri, self.name = names[int(namespace or 0)], name
        self.data_type = resolve(element.get("DataType", "i=24"))
        self.references = []


class CompanionTypes:
    def __init__(self, folder):
        self.nodes = {}
        for file in FILES:
            self._read(os.path.join(folder, file))
        for node_id, node in list(self.nodes.items()):
            for kind, forward, other in node.references:
                if not forward and other in self.nodes:
                    self.nodes[other].references.append((kind, True, node_id))

    def _read(self, file):
        root = ElementTree.parse(file).getroot()
        names = [UA] + [uri.text for uri in root.findall(f"{SCHEMA}NamespaceUris/{SCHEMA}Uri")]
        aliases = {alias.get("Alias"): alias.text for alias in root.findall(f"{SCHEMA}Aliases/{SCHEMA}Alias")}

        def resolve(text):
            text = aliases.get(text, text)
            index, _, rest = text.removeprefix("ns=").rpartition(";") if text.startswith("ns=") else ("0", "", text)
            return names[int(index)], rest

        for element in root:
            if not element.get("NodeId"):
                continue
            node = Node(element, names, resolve)
            self.nodes[resolve(element.get("NodeId"))] = node
            for reference in element.findall(f"{SCHEMA}References/{SCHEMA}Reference"):
                node.references.append((resolve(reference.get("ReferenceType"))[1],
                                        reference.get("IsForward") != "false", resolve(reference.text)))

    def _first(self, node_id, kind, forward=True):
        return next((other for one, way, other in self.nodes[node_id].references if (one, way) == (kind, forward)), None)

    def chain(self, type_id):
        """The type and those it is derived from."""
        while type_id in self.nodes:
            yield type_id
            type_id = self._first(type_id, HAS_SUBTYPE, False)

    def is_a(self, type_id, base):
        return base in self.chain(type_id)

    def type_id(self, uri, name):
        return next(key for key, node in self.nodes.items()
                    if (node.uri, node.name) == (uri, name) and node.kind.endswith("Type"))

    def mandatory(self, type_id):
        found = {}
        for derived in self.chain(type_id):
            for kind, forward, other in self.nodes[derived].references:
                part = self.nodes.get(other)
                if not forward or kind not in PARTS or not part or part.name.startswith("<"):
                    continue
                if self._first(other, HAS_RULE) == (UA, MANDATORY):
                    found.setdefault((part.uri, part.name),
                                     (part.uri, part.name, part.kind, self._first(other, HAS_TYPE), part.data_type))
        return list(found.values())
