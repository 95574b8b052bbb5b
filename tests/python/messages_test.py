"""Messages of both generations by name: fields, bytes, errors."""
import decimal
import enum
import json
import os
import pathlib

import jauscat
import pytest

data = pathlib.Path(os.environ["JAUSCAT_TEST_DATA"])


def vectors(name):
    with open(data / name, encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def all_of(message):
    """Its fields, with the presence vector, by which empty lists are told apart."""
    vector = message.presence_vector
    return message.fields if vector is None else {"presence_vector": vector, **message.fields}


def test_golden_messages_of_ra_decode_to_their_names_and_encode_to_their_bytes():
    seen = set()
    for vector in vectors("ra_vectors.jsonl"):
        whole = bytes.fromhex(vector["hex"])
        known = jauscat.message(int(vector["code"], 16))
        assert known == jauscat.message(vector["message"])
        message = known.decode(whole[16:])
        assert known.encode(all_of(message)) == whole[16:] == message.body, vector
        for name, value in message.fields.items():  # integers and real numbers as the vector has them
            same = [v for k, v in (vector["fields"] or {}).items() if k.lower().replace(" ", "_") == name]
            if same and isinstance(same[0], int) and isinstance(value, int):
                assert same[0] == value, (vector, name)
        seen.add(known.code)
    assert len(seen) == len(jauscat.messages()) - 1  # 0404h is not in the standard


def test_golden_messages_of_sae_decode_and_encode_to_their_bytes():
    seen = set()
    for vector in vectors("sae_vectors.jsonl"):
        payload = bytes.fromhex(vector["hex"])
        known = jauscat.message(int(vector["code"], 16), "sae")
        message = known.decode(payload)
        assert known.encode(all_of(message)) == payload, vector
        whole = jauscat.encode(known.code, all_of(message), to="2.1.33", source="1.1.32", generation="sae")
        assert jauscat.decode(whole, "sae").fields == message.fields
        seen.add(known.code)
    assert len(seen) == len(jauscat.messages("sae"))


def test_a_message_has_the_bytes_of_the_standard():
    whole = jauscat.encode("set_wrench_effort", {"propulsive_linear_effort_x": 50}, to="2.1.33.1", source="1.1.32.1")
    assert whole.hex() == "0602050401210102012001010400000001000040"
    message = jauscat.decode(whole)
    assert (message.name, message.code, message.source, message.destination) == ("set_wrench_effort", 0x0405, "1.1.32.1", "2.1.33.1")
    assert message["propulsive_linear_effort_x"] == pytest.approx(50, abs=0.01)
    assert "propulsive_linear_effort_y" not in message
    assert message.presence_vector == 1 and not message.wants_acknowledgement
    assert "propulsive_linear_effort_x = 50.001526 % (raw 16384)" in str(message)


def test_fields_have_units_ranges_names_and_presence_bits():
    first, second = jauscat.message("set_wrench_effort").fields[:2]
    assert (first.name, first.kind, first.unit, first.lowest, first.highest) == ("propulsive_linear_effort_x", "real", "%", -100, 100)
    assert first.optional and (first.presence_bit, second.presence_bit) == (0, 1)
    (state,) = [one for one in jauscat.message("report_component_status").fields if one.kind == "enumeration"]
    assert state.names[1] == "ready" and (state.lowest, state.highest) == (0, 255)
    (joints,) = jauscat.message("set_joint_efforts").fields
    assert joints.kind == "list" and joints.fields[0].unit == "%" and joints.most == 255


def test_every_message_of_both_generations_describes_its_fields():
    for generation, count in ("ra", 158), ("sae", 276):
        known = jauscat.messages(generation)
        assert len(known) == count
        assert [one.code for one in known] == sorted(one.code for one in known)
        for one in known:
            assert one.min_size <= one.max_size
            if one.report:
                assert jauscat.message(one.report, generation).query == one.code
            fields = list(one.fields)
            while fields:
                field = fields.pop()
                assert field.kind
                if field.kind == "real":
                    assert field.lowest < field.highest, (one, field)
                fields += field.fields


def test_values_may_be_any_number_of_python():
    known = jauscat.message("set_travel_speed")

    class speed(enum.IntEnum):
        slow = 2

    two = known.encode({"desired_speed": 2})
    assert two == known.encode({"desired_speed": 2.0}) == known.encode({"desired_speed": decimal.Decimal(2)})
    assert two == known.encode({"desired_speed": speed.slow}) == known.encode({"desired_speed": "2 m/s"})
    assert two == known.from_text("desired_speed=2")
    with pytest.raises(TypeError):
        known.encode({"desired_speed": object()})
    endless = []
    endless.append(endless)
    with pytest.raises(TypeError):
        known.encode({"desired_speed": endless})


def test_an_enumeration_is_encoded_by_name_and_by_number():
    known = jauscat.message("set_emergency")
    assert known.encode({"emergency_code": "transition_to_emergency"}) == known.encode({"emergency_code": 1})


def test_what_does_not_decode_says_field_and_byte():
    with pytest.raises(jauscat.DecodeError, match="propulsive_linear_effort_x at byte 2 needs 2 bytes, 1 left") as caught:
        jauscat.message("set_wrench_effort").decode(bytes([1, 0, 7]))
    assert (caught.value.field, caught.value.byte) == ("propulsive_linear_effort_x", 2)
    assert caught.value.reason == "truncated: the bytes end before the last field"
    whole = bytearray(jauscat.encode("set_wrench_effort", {"propulsive_linear_effort_x": 50}, to="2.1.33.1", source="1.1.32.1"))
    whole[12] = 3  # data size
    with pytest.raises(jauscat.DecodeError) as caught:
        jauscat.decode(bytes(whole[:-1]))
    assert caught.value.byte == 18  # of the whole message


def test_what_does_not_encode_says_its_field():
    with pytest.raises(jauscat.EncodeError, match="must be -100 to 100 %") as caught:
        jauscat.message("set_wrench_effort").encode({"propulsive_linear_effort_x": 101})
    assert caught.value.field == "propulsive_linear_effort_x" and caught.value.byte is None
    with pytest.raises(jauscat.EncodeError, match="did you mean") as caught:
        jauscat.message("set_wrench_effort").encode({"propulsive_linear_effort": 10})
    with pytest.raises(jauscat.EncodeError):
        jauscat.message("set_joint_efforts").encode({"joint": [{"joint_effort": 1}, {"joint_effort": 200}]})
    assert isinstance(caught.value, jauscat.Error)


def test_an_unknown_message_is_an_error_with_a_suggestion():
    with pytest.raises(jauscat.UnknownMessageError, match="did you mean set_wrench_effort"):
        jauscat.message("set_wrench_efort")
    with pytest.raises(jauscat.UnknownMessageError):
        jauscat.message(0x7777)
    with pytest.raises(ValueError, match="'ra' or 'sae'"):
        jauscat.messages("4.0")


def test_a_datagram_of_either_generation_has_its_messages():
    whole = jauscat.encode("query_component_status", to="2.1.33.1", source="1.1.32.1")
    assert [one.name for one in jauscat.decode_datagram(whole)] == ["query_component_status"]
    assert [one.name for one in jauscat.decode_datagram(b"JAUS01.0" + whole)] == ["query_component_status"]
    sae = jauscat.encode("query_status", to="2.1.33", source="1.1.32", generation="sae")
    assert [one.name for one in jauscat.decode_datagram(b"\x02" + sae + sae)] == ["query_status", "query_status"]
    assert jauscat.decode_datagram(b"no JAUS") == []


@pytest.mark.parametrize("table,base", [("seed", 6900), ("seed", 0x2000), ("self-contained", 6900), ("self-contained", 0x6900)])
def test_a_message_of_ra_becomes_an_object_and_comes_back(table, base):
    whole = jauscat.encode("set_wrench_effort", {"propulsive_linear_effort_x": 50}, to="2.1.33.1", source="1.1.32.1", sequence_number=7)
    packet = jauscat.translate(whole, table, base)
    assert (packet.node, packet.index, packet.subindex) == (1, base + 33, 26)
    assert jauscat.translate_back(packet.packet, table, base) == whole
    assert packet.packet.endswith(packet.data) and packet.data.endswith(bytes.fromhex("01000040"))


def test_a_message_of_sae_becomes_an_object_and_comes_back():
    whole = jauscat.encode("query_status", to="2.1.33", source="1.1.32", generation="sae", sequence_number=9)
    packet = jauscat.translate(whole, "sae")
    assert packet.node == 1 and 0x2000 <= packet.index < 0x3000
    assert jauscat.translate_back(packet.packet, "sae") == whole


def test_a_table_refuses_what_it_cannot_carry():
    with pytest.raises(jauscat.TranslateError, match="truncated"):
        jauscat.translate(b"\x06\x02")
    with pytest.raises(ValueError, match="'seed', 'self-contained' or 'sae'"):
        jauscat.translate(bytes(16), "other")
