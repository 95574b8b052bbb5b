# Messages by name: what docs/python.md shows.
# [messages]
import jauscat

whole = jauscat.encode("set_wrench_effort", {"propulsive_linear_effort_x": 50}, to="2.2.33.1", source="1.1.32.1")
print(whole.hex())
message = jauscat.decode(whole)
print(message.name, message.source, message["propulsive_linear_effort_x"])
print(message)
# [messages end]

# [facts]
known = jauscat.message("set_travel_speed")
for field in known.fields:
    print(f"{known.name}: {field.name}, {field.lowest:g} to {field.highest:g} {field.unit}")
print(len(jauscat.messages()), "messages of RA 3.3,", len(jauscat.messages("sae")), "of SAE services")
# [facts end]

# [errors]
try:
    jauscat.message("set_wrench_effort").decode(b"\x01\x00\x40")
except jauscat.DecodeError as error:
    print(error)
    print(error.field, error.byte)
try:
    known.encode({"desired_speed": 30000})
except jauscat.EncodeError as error:
    print(error)
# [errors end]

# [translate]
packet = jauscat.translate(whole, table="self-contained", index_base=0x2000)
print(packet, len(packet.data), "bytes")
print(jauscat.translate_back(packet.packet, table="self-contained", index_base=0x2000) == whole)
# [translate end]
