"""Compares what tshark shows by the dissector with what jausdump prints as JSON, field by field."""
import json
import math
import os
import subprocess
import xml.etree.ElementTree as xml


class Difference(Exception):
    """Where tshark and jausdump differ."""


def tshark(dissector, arguments):
    """What tshark prints. It says on stderr alone that a script has an error."""
    made = subprocess.run(["tshark", "-X", f"lua_script:{dissector}", *arguments], capture_output=True, check=False)
    said = [line for line in made.stderr.decode().splitlines() if "Running as user" not in line]
    if made.returncode != 0 or said:
        raise Difference(f"tshark {' '.join(arguments)}: exit code {made.returncode}: {said}")
    if b"Lua Error" in made.stdout or b"_ws.lua.error" in made.stdout:
        text = made.stdout.decode(errors="replace")
        at = text.find("Lua Error")
        raise Difference(f"tshark {' '.join(arguments)}: {text[at:at + 300]}")
    return made.stdout


def messages_of_tshark(dissector, capture, arguments=()):
    """Pairs of frame number and the tree of a message."""
    pdml = tshark(dissector, ["-r", capture, "-Y", "jaus && !icmp", "-T", "pdml", *arguments])
    found = []
    for packet in xml.fromstring(pdml).iter("packet"):
        number = None
        for proto in packet.findall("proto"):
            if proto.get("name") == "geninfo":
                number = int(next(f.get("show") for f in proto if f.get("name") == "num"))
            if proto.get("name") == "jaus":
                found.append((number, proto))
    return found


def messages_of_jausdump(jausdump, capture, arguments=()):
    made = subprocess.run([jausdump, capture, "--format", "json", *arguments], capture_output=True, check=False)
    if made.returncode not in (0, 1):
        raise Difference(f"jausdump {capture}: exit code {made.returncode}: {made.stderr.decode()}")
    return [json.loads(line) for line in made.stdout.splitlines()]


def named(element, name):
    """The fields of a name. One whose type differs from that of another field with the name has it at its end."""
    types = ("unsigned", "unsigned64", "signed", "signed64", "bool", "double", "string", "bytes", "none")
    names = {name} | {f"{name}_{type}" for type in types}
    return [one for one in element if one.get("name") in names]


def bytes_of(field):
    return bytes.fromhex(field.get("value") or "")


def same_real(shown, wanted):
    if isinstance(wanted, str):
        return float(shown.replace("inf", "Infinity")) == float(wanted) or (wanted == "NaN" and "nan" in shown.lower())
    return math.isclose(float(shown), wanted, rel_tol=1e-14, abs_tol=0)


def require_value(field, wanted, where):
    """A number, text or bytes."""
    shown = field.get("show")
    if isinstance(wanted, dict) and "value" in wanted:
        raw = int.from_bytes(bytes_of(field), "little")
        modulus = 1 << 8 * len(bytes_of(field))
        equal = same_real(shown, wanted["value"]) and raw == wanted["raw"] % modulus
    elif isinstance(wanted, dict):
        equal = bytes_of(field).hex() == wanted["hex"]
    elif isinstance(wanted, int):
        equal = int(shown, 0) == wanted
    elif isinstance(wanted, float) or wanted in ("NaN", "Infinity", "-Infinity"):
        equal = same_real(shown, wanted)
    else:
        equal = bytes_of(field).hex() == wanted or bytes_of(field) == wanted.encode()
    if not equal:
        raise Difference(f"{where}: tshark shows {shown} ({field.get('value')}), jausdump {wanted}")


def is_leaf(wanted):
    return not isinstance(wanted, (dict, list)) or (isinstance(wanted, dict) and set(wanted) in ({"value", "raw"}, {"hex"}))


def require_fields(wanted, element, prefix, extra=()):
    """All fields of an object are in the tree below `element`, and no others."""
    for key, value in wanted.items():
        name = f"{prefix}.{key}"
        if key == "child":  # nodes of a tree lie in each other
            require_list(value, named(element, prefix), prefix)
            continue
        fields = named(element, name)
        if isinstance(value, dict) and set(value) == {"value"} and not fields:  # by the form that another field selects
            fields, value = named(element, name + ".value"), value["value"]
        if isinstance(value, list):
            require_list(value, fields, name)
        elif value is not None and value != {}:
            if len(fields) != 1:
                raise Difference(f"{name}: tshark shows it {len(fields)} times")
            if is_leaf(value):
                require_value(fields[0], value, name)
            else:
                require_fields(value, fields[0], name)
    known = set(wanted) | {"presence_vector", "alternative"} | set(extra)
    for field in element:
        name = field.get("name") or ""
        if name.startswith(prefix + ".") and not any(
                name == f"{prefix}.{key}" or name.startswith((f"{prefix}.{key}_", f"{prefix}.{key}.")) for key in known):
            raise Difference(f"{name}: jausdump has no such field in {sorted(wanted)}")


def require_list(wanted, fields, name):
    if len(wanted) != len(fields):
        raise Difference(f"{name}: tshark shows {len(fields)} elements, jausdump {len(wanted)}")
    for one, field in zip(wanted, fields):
        if is_leaf(one):
            require_value(field, one, name)
        else:
            require_fields(one, field, name)


def has_expert_info(element, name="_ws.expert"):
    return any(one.get("name") == name for one in element.iter("field"))


def holds_a_message(proto):
    """Whether another message is in a field of the message."""
    codes = ("jaus.command_code", "jaus.message_id")
    return sum(one.get("name") in codes for one in proto.iter("field")) > 1


def require_message(record, proto):
    """A message of jausdump is the one that tshark shows."""
    if "refusal" in record:
        if not has_expert_info(proto) or int(record["code"], 0) != int(named(proto, "jaus.command_code")[0].get("show"), 0):
            raise Difference(f"refusal {record['refusal']}")
        return
    header = dict(record["header"] or {})
    if record.get("data_set") == "reassembled":  # its size need not fit a header
        header.pop("data_size", None)
        header.pop("size", None)
    for key, value in header.items():
        name = f"jaus.{key}"
        if key in ("destination", "source"):
            require_fields(value, named(proto, name)[0], name)
        else:
            require_value(named(proto, name)[0], value, name)
    if "error" in record and not has_expert_info(proto):
        raise Difference(f"no expert information says: {record['error']['text']}")
    if record["fields"] is None:
        return
    body = [one for one in proto if (one.get("showname") or "").split(" [")[0] == record["message"] and
            one.get("name", "").startswith("jaus.")]
    if len(body) != 1:
        raise Difference(f"tshark shows {len(body)} bodies of {record['message']}")
    prefix = body[0].get("name")
    require_fields(record["fields"], body[0], prefix)
    if record["presence_vector"] is not None:
        # jausdump leaves the bits out that stand for no field.
        shown = int(named(body[0], prefix + ".presence_vector")[0].get("show"), 0)
        wanted = int(record["presence_vector"], 0)
        if shown != wanted and shown ^ wanted != int(record.get("ignored_presence_bits", "0"), 0):
            raise Difference(f"presence vector: tshark shows {shown:#x}, jausdump {wanted:#x}")


def require_shown(wanted, dissector, capture, arguments, packets=None):
    """Of two passes, both show the messages. `packets`: the frames that have them; else the records say it."""
    for passes in ((), ("-2",)):
        shown = messages_of_tshark(dissector, capture, [*passes, *arguments])
        if len(wanted) != len(shown):
            raise Difference(f"{os.path.basename(capture)}: tshark shows {len(shown)} messages, jausdump {len(wanted)}")
        for at, (record, (number, proto)) in enumerate(zip(wanted, shown)):
            try:
                packet = packets[at] if packets else record["origin"]["packet"]
                if number != packet:
                    raise Difference(f"jausdump shows it in packet {packet}")
                require_message(record, proto)
            except (Difference, IndexError) as difference:
                raise Difference(f"{os.path.basename(capture)}, frame {number}, {record['message']}: {difference!r}\n"
                                 f"{json.dumps(record)}\n{xml.tostring(proto).decode()}") from difference


def require_same(dissector, jausdump, capture, dump_arguments=(), tshark_arguments=()):
    """Returns the number of messages, and of those that were decoded."""
    wanted = messages_of_jausdump(jausdump, capture, dump_arguments)
    require_shown(wanted, dissector, capture, tshark_arguments)
    return len(wanted), sum(record["fields"] is not None for record in wanted)


def require_frames(dissector, capture, display_filter, wanted, arguments=()):
    """The frames that a filter passes."""
    shown = tshark(dissector, ["-r", capture, "-2", *arguments, "-Y", display_filter, "-T", "fields", "-e", "frame.number"])
    frames = [int(number) for number in shown.split()]
    if frames != wanted:
        raise Difference(f"{display_filter}: passes frames {frames}, not {wanted}")
