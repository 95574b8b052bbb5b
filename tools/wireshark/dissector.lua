-- The dissector. It knows the forms of values and the transports, and no message.

-- Loaded before, from a folder of plugins.
if Dissector.get("jaus") then return end

local jaus = Proto("jaus", "JAUS")

jaus.prefs.mobility = Pref.enum("Mobility services", 1, "Version of the SAE mobility services",
    {{1, "1.1", 1}, {2, "1.0", 2}}, false)
jaus.prefs.ethercat_table = Pref.enum("EtherCAT table", 1, "Mapping table of JAUS messages in EtherCAT objects",
    {{1, "RA", 1}, {2, "seed", 2}, {3, "self-contained", 3}, {4, "SAE", 4}, {5, "none", 5}}, false)
jaus.prefs.ethercat_index_base = Pref.uint("EtherCAT index base", 6900,
    "Object index of component 0: 6900, 8192 (2000h) or 26880 (6900h)")
jaus.prefs.ethercat_subsystem = Pref.uint("EtherCAT subsystem", 0,
    "JAUS subsystem of the slaves, which the seed table leaves out")
jaus.prefs.ethercat_fixed_length = Pref.bool("EtherCAT objects of fixed length", false,
    "The data of an object begin with their length, in two bytes")

local experts = {
    truncated = ProtoExpert.new("jaus.truncated", "Truncated", expert.group.MALFORMED, expert.severity.ERROR),
    trailing = ProtoExpert.new("jaus.trailing", "Trailing bytes", expert.group.MALFORMED, expert.severity.WARN),
    out_of_range = ProtoExpert.new("jaus.out_of_range", "Out of range", expert.group.PROTOCOL, expert.severity.WARN),
    outside_values = ProtoExpert.new("jaus.outside_values", "Outside its values", expert.group.PROTOCOL,
        expert.severity.WARN),
    unknown = ProtoExpert.new("jaus.unknown", "Unknown", expert.group.UNDECODED, expert.severity.WARN),
    malformed = ProtoExpert.new("jaus.malformed", "Malformed", expert.group.MALFORMED, expert.severity.ERROR),
    refused = ProtoExpert.new("jaus.refused", "Refused by a slave or its master", expert.group.RESPONSE_CODE,
        expert.severity.NOTE),
}
jaus.experts = {experts.truncated, experts.trailing, experts.out_of_range, experts.outside_values, experts.unknown,
    experts.malformed, experts.refused}

-- Fields ------------------------------------------------------------------------------------------------------------

local all_fields, field_by_key, type_of_abbreviation = {}, {}, {}

-- Types that may share an abbreviation. RA and SAE have many messages with the same names.
local common_type = {uint8 = "unsigned", uint16 = "unsigned", uint32 = "unsigned", uint64 = "unsigned64",
    int8 = "signed", int16 = "signed", int32 = "signed", int64 = "signed64"}

-- A field; the same one where all is the same. `kind` is a function of ProtoField.
local function new_field(kind, abbreviation, title, ...)
    local type = common_type[kind] or kind
    local known = type_of_abbreviation[abbreviation]
    if known and known ~= type then abbreviation = abbreviation .. "_" .. type end
    type_of_abbreviation[abbreviation] = type
    local key = table.concat({kind, abbreviation, title}, " ")
    for i = 1, select("#", ...) do key = key .. " " .. tostring((select(i, ...))) end
    local made = field_by_key[key]
    if not made then
        made = ProtoField[kind](abbreviation, title, ...)
        field_by_key[key] = made
        all_fields[#all_fields + 1] = made
    end
    return made
end

-- propulsive_linear_effort_x: Propulsive Linear Effort X
local function title_of(name)
    return (name:gsub("_", " "):gsub("%f[%w]%l", string.upper))
end

-- Compiled structures: the tables, with the fields of one message ------------------------------------------------------

local compile_structure
local structure_notations = {
    address = function(v) return ("%d.%d.%d.%d"):format(v.subsystem, v.node, v.component, v.instance) end,
    jaus_id = function(v) return ("%d.%d.%d"):format(v.subsystem, v.node, v.component) end,
}

-- A value of a form. `abbreviation` is that of its field.
local function compile(form_number, abbreviation, title)
    local form = forms[form_number]
    local kind = form[1]
    local node = {kind = kind, form = form, title = title, unit = form.unit and " " .. form.unit or ""}
    if kind == "integer" then
        node.size = form.bits / 8
        if form.boolean then
            node.field = new_field("bool", abbreviation, title)
        else
            node.field = new_field((form.signed and "int" or "uint") .. form.bits, abbreviation, title, base.DEC,
                form.names and names[form.names])
        end
        if form.flags then
            node.bits = {}
            for bit, name in pairs(names[form.flags]) do
                node.bits[#node.bits + 1] = new_field("bool", abbreviation .. "." .. name, title_of(name), form.bits, nil,
                    2 ^ bit)
            end
        end
    elseif kind == "real" then
        node.size = form.bits / 8
        node.field = new_field("double", abbreviation, title)
    elseif kind == "scaled" then
        node.size = form.bits / 8
        node.field = new_field("double", abbreviation, title)
        local steps = 2 ^ form.bits - (form.signed and 2 or 1)
        node.scale = (form.max - form.min) / steps
        node.bias = form.signed and (form.min + form.max) / 2 or form.min
    elseif kind == "octets" then
        node.field = new_field(form.text and "string" or "bytes", abbreviation, title)
    elseif kind == "structure" then
        node.notation = structure_notations[structures[form[2]][1]]
        node.field = new_field(node.notation and "string" or "none", abbreviation, title)
        node.structure = compile_structure(form[2], abbreviation)
    elseif kind == "packed" then
        node.size = form.bits / 8
        node.field = new_field("uint" .. form.bits, abbreviation, title, base.DEC)
        node.structure = compile_structure(form[2], abbreviation)
    elseif kind == "message" then
        node.field = new_field("bytes", abbreviation, title)
        node.structure = form[2] and compile_structure(form[2], abbreviation)
    elseif kind == "list" then
        node.count = form.count
        local field = form.field
        if field then node.field = new_field("none", abbreviation, title) end
        node.element = compile(form[2], field and abbreviation .. "." .. field or abbreviation,
            field and title_of(field) or title)
    elseif kind == "tree" then
        node.element = compile(form[2], abbreviation, title)
    elseif kind == "choice" then
        node.cases = {}
        local tags = {}
        for tag in pairs(form[2]) do tags[#tags + 1] = tag end
        table.sort(tags) -- the type of the first case has the name alone
        for _, tag in ipairs(tags) do
            local case = form[2][tag]
            local is_structure = case ~= 0 and forms[case][1] == "structure"
            node.cases[tag] = case == 0 and "none" or
                compile(case, is_structure and abbreviation or abbreviation .. ".value", title)
        end
    elseif kind == "variant" then
        node.size = form.bits / 8
        node.field = new_field("none", abbreviation, title)
        local titles = {}
        node.alternatives = {}
        for i, one in ipairs(form[2]) do
            titles[i - 1] = one[1]
            node.alternatives[i - 1] = one[2] and compile(one[2], abbreviation .. "." .. one[1], title_of(one[1])) or "none"
        end
        node.tag_field = new_field("uint" .. form.bits, abbreviation .. ".alternative", "Alternative", base.DEC, titles)
    end
    return node
end

-- Bits of a presence vector, by what they stand for.
local function compile_presence(members, at, abbreviation, bits)
    local made, known = {}, {}
    for i = at + 1, #members do
        local one = members[i]
        if one.vector then break end
        if one.bit and not one.counts and not known[one.bit] then
            known[one.bit] = true
            made[#made + 1] = new_field("bool", abbreviation .. "." .. one[1], title_of(one[1]), bits, nil, 2 ^ one.bit)
        end
    end
    return made
end

function compile_structure(number, prefix)
    local source = structures[number]
    local made = {number = number, members = {}}
    for i = 2, #source do
        local member = source[i]
        local abbreviation, title = prefix .. "." .. member[1], title_of(member[1])
        local node
        if member.first then
            local form = forms[member[2]]
            node = {kind = "bit_field", title = title, form = form, width = form.bits}
            local is_plain = member.carrier <= 32
            local mask = is_plain and (2 ^ form.bits - 1) * 2 ^ member.first or nil
            if form.boolean and is_plain then
                node.field = new_field("bool", abbreviation, title, member.carrier, nil, mask)
            else
                node.field = new_field("uint" .. member.carrier, abbreviation, title, base.DEC,
                    form.names and names[form.names], mask)
            end
        elseif member.flag then
            node = {kind = "flag"}
        elseif member.constant then
            node = {kind = "constant", title = title, size = forms[member[2]].bits / 8}
        elseif member.vector then
            local bits = forms[member[2]].bits
            node = {kind = "presence_vector", title = title, size = bits / 8,
                field = new_field("uint" .. bits, abbreviation, title, base.HEX),
                bits = compile_presence(source, i, abbreviation, bits)}
        else
            node = compile(member[2], abbreviation, title)
        end
        node.name, node.member = member[1], member
        made.members[#made.members + 1] = node
    end
    for i, node in ipairs(made.members) do
        -- A count is absent together with its list.
        node.gate = node.member.gate or (node.member.counts and made.members[i + 1].member.gate)
    end
    return made
end

-- Messages of one list by their codes. Those of the second list replace it.
local function compile_messages(...)
    local made = {}
    for _, list in ipairs({...}) do
        for code, message in pairs(list) do
            made[code] = {name = message[1], title = message[2], query = message.query, report = message.report,
                field = new_field("none", "jaus." .. message[1], message[2]),
                structure = compile_structure(message[3], "jaus." .. message[1])}
        end
    end
    return made
end

local function titles_of(messages)
    local made = {}
    for code, message in pairs(messages) do made[code] = message.title end
    return made
end

local ra_header = compile_structure(header_structure, "jaus")
local sae_header = compile_structure(transport_structure, "jaus")
local ra = compile_messages(ra_messages)
local sae = compile_messages(sae_messages)
local sae_1_0 = compile_messages(sae_messages, sae_messages_1_0)

local command_code_field = new_field("uint16", "jaus.command_code", "Command Code", base.HEX, titles_of(ra))
for _, node in ipairs(ra_header.members) do
    if node.name == "command_code" then node.field = command_code_field end
end
local message_id_field = new_field("uint16", "jaus.message_id", "Message ID", base.HEX, titles_of(sae))
local sequence_number_field = new_field("uint16", "jaus.sequence_number", "Sequence Number", base.DEC)
local framing_field = new_field("string", "jaus.framing", "Framing")
local body_field = new_field("bytes", "jaus.body", "Body")
local compression_number_field = new_field("uint8", "jaus.compression.number", "Compression Number", base.DEC)
local compression_length_field = new_field("uint8", "jaus.compression.length", "Compression Length", base.DEC)
local query_field = new_field("framenum", "jaus.query_in", "Query in frame", base.NONE, frametype.REQUEST)
local report_field = new_field("framenum", "jaus.report_in", "Report in frame", base.NONE, frametype.RESPONSE)
local time_field = new_field("relative_time", "jaus.response_time", "Time from the query to its report")
local packet_field = new_field("framenum", "jaus.packet", "Packet in frame", base.NONE)
local whole_field = new_field("framenum", "jaus.reassembled_in", "Reassembled in frame", base.NONE)
local object_field = new_field("string", "jaus.object", "EtherCAT object")
jaus.fields = all_fields

-- Values ------------------------------------------------------------------------------------------------------------

-- What is thrown where the rest of a message cannot be decoded; the tree says why already.
local stop = {}

-- Takes the place of a tree.
local nothing = {}
setmetatable(nothing, {__index = function() return function() return nothing end end})

local readers = {}
local read_structure, dissect_inner

local function fail(tree, expert_info, text)
    tree:add_proto_expert_info(expert_info, text)
    error(stop, 0)
end

-- The next `size` bytes.
local function take(data, size, tree, title)
    local left = data.limit - data.at
    if size > left then
        fail(tree, experts.truncated, ("Truncated: %s at byte %d needs %d bytes, %d left"):format(title,
            data.at - data.begin, size, left))
    end
    local range = data.tvb(data.at, size)
    data.at = data.at + size
    return range
end

local function integer_of(range, signed)
    if range:len() == 8 then return (signed and range:le_int64() or range:le_uint64()):tonumber() end
    return signed and range:le_int() or range:le_uint()
end

local function has_bit(number, bit) return math.floor(number / 2 ^ bit) % 2 == 1 end

-- A member of the structure `reference[1]` around; 0 is the innermost one. The name may be a path.
local function look_up(scope, reference)
    local number = reference[1]
    while number ~= 0 and scope.number ~= number do scope = scope.outer end
    local value = scope.values
    for name in reference[2]:gmatch("[^.]+") do value = value[name] end
    return value
end

-- Of a form with a value set.
local function check_values(form, value, item)
    if not form.values then return end
    for _, range in ipairs(form.values) do
        if value >= range[1] and value <= range[2] then return end
    end
    item:add_proto_expert_info(experts.outside_values, ("Outside its values: %.0f"):format(value))
end

function readers.integer(node, data, tree)
    local range = take(data, node.size, tree, node.title)
    local value = integer_of(range, node.form.signed)
    local item = tree:add_le(node.field, range)
    if node.unit ~= "" then item:append_text(node.unit) end
    if node.bits then
        for _, field in ipairs(node.bits) do item:add_le(field, range) end
    elseif node.form.names and not names[node.form.names][value] then
        item:add_proto_expert_info(experts.unknown, ("Unknown: %d has no meaning"):format(value))
    end
    check_values(node.form, value, item)
    return value
end

-- Bits without a meaning may have any value.
function readers.constant(node, data, tree)
    local value = integer_of(take(data, node.size, tree, node.title))
    if value ~= node.member.constant and node.name ~= "reserved" then
        fail(tree, experts.unknown, ("Unknown: %s is %d, not %d"):format(node.title, value, node.member.constant))
    end
end

function readers.real(node, data, tree)
    local range = take(data, node.size, tree, node.title)
    tree:add(node.field, range, range:le_float()):append_text(node.unit)
end

function readers.scaled(node, data, tree)
    local range = take(data, node.size, tree, node.title)
    local raw = integer_of(range, node.form.signed)
    local value = raw * node.scale + node.bias
    local item = tree:add(node.field, range, value)
    item:append_text(("%s (raw %.0f)"):format(node.unit, raw))
    if node.form.signed and raw == -2 ^ (node.form.bits - 1) then
        fail(item, experts.out_of_range, ("Out of range: the raw value %.0f is not legal"):format(raw))
    end
    return value
end

function readers.octets(node, data, tree, _, count)
    local form = node.form
    local size = form.rest and data.limit - data.at or form.size or count
    if form.terminated then
        size = 0
        while data.at + size < data.limit and data.tvb(data.at + size, 1):uint() ~= 0 do size = size + 1 end
        local range = take(data, size + 1, tree, node.title)
        tree:add(node.field, range(0, size))
        return
    end
    local range = take(data, size, tree, node.title)
    if form.filled then
        while size > 0 and range(size - 1, 1):uint() == 0 do size = size - 1 end
        range = range(0, size)
    end
    tree:add(node.field, range)
end

function readers.structure(node, data, tree, scope)
    local begin = data.at
    local text
    if node.notation then
        local ahead = {tvb = data.tvb, begin = data.begin, at = begin, limit = data.limit}
        local decoded, values = pcall(read_structure, node.structure, ahead, nothing, scope)
        text = decoded and node.notation(values) or ""
    end
    local item = text and tree:add(node.field, data.tvb(begin, 0), text) or tree:add(node.field, data.tvb(begin, 0))
    local values = read_structure(node.structure, data, item, scope)
    item:set_len(data.at - begin)
    return values
end

function readers.packed(node, data, tree, scope)
    local range = take(data, node.size, tree, node.title)
    local item = tree:add_le(node.field, range)
    data.at = data.at - node.size
    read_structure(node.structure, data, item, scope)
    return integer_of(range)
end

function readers.message(node, data, tree, scope, count)
    local begin = data.at
    if node.structure then
        local decoded, problem = pcall(read_structure, node.structure, data, nothing, scope)
        if not decoded and problem ~= stop then error(problem, 0) end
        if not decoded then
            fail(tree, experts.truncated, ("Truncated: %s at byte %d ends too early"):format(node.title, begin - data.begin))
        end
        count = data.at - begin
        data.at = begin
    end
    local range = take(data, count, tree, node.title)
    local item = tree:add(node.field, range)
    if count > 0 then dissect_inner(data, begin, count, item) end
end

function readers.list(node, data, tree, scope, count)
    for i = 1, node.count or count do
        local begin = data.at
        if node.field then
            local item = tree:add(node.field, data.tvb(begin, 0))
            item:append_text((" [%d]"):format(i))
            readers[node.element.kind](node.element, data, item, scope)
            item:set_len(data.at - begin)
        else
            readers[node.element.kind](node.element, data, tree, scope)
        end
    end
end

-- A node, then its children, inside it.
local function read_node(node, data, tree, scope, level)
    if level > node.form.depth then fail(tree, experts.malformed, "Malformed: more levels than a tree may have") end
    local begin = data.at
    local item = tree:add(node.element.field, data.tvb(begin, 0))
    local values = read_structure(node.element.structure, data, item, scope)
    for _ = 1, values[node.form.children] do read_node(node, data, item, scope, level + 1) end
    item:set_len(data.at - begin)
end
function readers.tree(node, data, tree, scope) read_node(node, data, tree, scope, 1) end

function readers.choice(node, data, tree, scope)
    local tag = look_up(scope, node.member.tag)
    local case = node.cases[tag]
    if not case then fail(tree, experts.unknown, ("Unknown: %s has no form for %d"):format(node.title, tag)) end
    if case ~= "none" then readers[case.kind](case, data, tree, scope) end
end

function readers.variant(node, data, tree, scope)
    local begin = data.at
    local range = take(data, node.size, tree, node.title)
    local item = tree:add(node.field, range)
    item:add_le(node.tag_field, range)
    local tag = integer_of(range)
    local held = node.alternatives[tag]
    if not held then fail(item, experts.unknown, ("Unknown: %s has no alternative %d"):format(node.title, tag)) end
    if held ~= "none" then readers[held.kind](held, data, item, scope) end
    item:set_len(data.at - begin)
end

local function read_presence_vector(node, members, at, data, tree, scope)
    local range = take(data, node.size, tree, node.title)
    local vector = integer_of(range)
    local item = tree:add_le(node.field, range)
    for _, field in ipairs(node.bits) do item:add_le(field, range) end
    if vector >= 2 ^ node.member.vector then
        item:add_proto_expert_info(experts.unknown, "Unknown: presence bits that stand for no field")
        if node.member.tolerant then data.drops_rest = true end
    end
    -- A field before a flag may be announced by it.
    for i = at + 1, #members do
        local member = members[i].member
        if member.vector then break end
        if member.flag then scope.values[member[1]] = has_bit(vector, member.bit) end
    end
    return vector
end

-- Reads a structure, and returns the values that others refer to.
function read_structure(structure, data, tree, outer)
    local scope = {number = structure.number, values = {}, outer = outer}
    local vector, count, word, word_value
    for i, node in ipairs(structure.members) do
        local member = node.member
        local present = not member.bit or has_bit(vector, member.bit)
        if node.gate and present then present = look_up(scope, node.gate) end
        if member.first then
            if not word then
                word = take(data, member.carrier / 8, tree, node.title)
                word_value = integer_of(word)
            end
            local value = math.floor(word_value / 2 ^ member.first) % 2 ^ node.width
            local item
            if member.carrier <= 32 then
                item = tree:add_le(node.field, word)
            else
                item = tree:add(node.field, word, UInt64.new(value % 2 ^ 32, math.floor(value / 2 ^ 32)))
            end
            local is_negative = node.form.signed and value >= 2 ^ (node.width - 1)
            check_values(node.form, is_negative and value - 2 ^ node.width or value, item)
            scope.values[node.name] = value
            if member.ends then word = nil end
        elseif member.vector then
            vector = read_presence_vector(node, structure.members, i, data, tree, scope)
        elseif present and not member.flag then
            local counter = member.counter
            if counter then count = math.max(look_up(scope, counter) - (member.excess or 0), 0) end
            local value = readers[node.kind](node, data, tree, scope, count)
            scope.values[node.name] = value
            if member.counts then count = value end
        end
    end
    return scope.values
end

-- Messages ------------------------------------------------------------------------------------------------------------

-- Reads with `f`; false where the bytes do not decode.
local function guarded(f, ...)
    local done, problem = pcall(f, ...)
    if not done and problem ~= stop then error(problem, 0) end
    return done and problem or done
end

-- The fields of a body; `data` is behind the message ID.
local function dissect_fields(message, data, tree)
    local item = tree:add(message.field, data.tvb(data.at, data.limit - data.at))
    guarded(function()
        read_structure(message.structure, data, item)
        if data.at == data.limit then return true end
        local rest = data.tvb(data.at, data.limit - data.at)
        if data.drops_rest then
            item:add(body_field, rest):append_text(" (of presence bits that stand for no field)")
        else
            item:add(body_field, rest):add_proto_expert_info(experts.trailing,
                ("Trailing: %d bytes behind the last field"):format(data.limit - data.at))
        end
        return true
    end)
end

local function sae_list() return jaus.prefs.mobility == 2 and sae_1_0 or sae end

local function dissect_ra_body(code, data, tree)
    local message = ra[code]
    if message then return dissect_fields(message, data, tree) end
    local range = data.tvb(data.at, data.limit - data.at)
    tree:add(body_field, range):add_proto_expert_info(experts.unknown,
        ("Unknown: command code 0x%04X is not one of the standard's"):format(code))
end

-- A payload of SAE JAUS, from the message ID on. Returns the message.
local function dissect_payload(data, tree)
    return guarded(function()
        local range = take(data, 2, tree, "Message ID")
        local item = tree:add_le(message_id_field, range)
        local message = sae_list()[range:le_uint()]
        if message then
            dissect_fields(message, data, tree)
            return message
        end
        fail(item, experts.unknown, ("Unknown: message ID 0x%04X is in no known service"):format(range:le_uint()))
    end)
end

-- A message in a field of another one: header and body of RA 3.3, a payload of SAE JAUS.
function dissect_inner(data, begin, size, tree)
    local inner = {tvb = data.tvb, begin = begin, at = begin, limit = begin + size, is_sae = data.is_sae}
    if data.is_sae then return dissect_payload(inner, tree) end
    guarded(function()
        local head = read_structure(ra_header, inner, tree)
        if inner.at < inner.limit then dissect_ra_body(head.command_code, inner, tree) end
        return true
    end)
end

-- Queries and their reports ------------------------------------------------------------------------------------------

local open_queries, links = {}, {}

local function matches(wanted, address)
    local parts = address:gmatch("%d+")
    for part in wanted:gmatch("%d+") do
        local other = parts()
        if part ~= other and part ~= "255" and part ~= "65535" then return false end
    end
    return true
end

-- Finds the query of a report once, in the first pass, and shows what was found.
local function link_query(message, source, destination, number, pinfo, tree)
    local id = table.concat({pinfo.number, message.name, source, destination, number}, " ")
    if message.report and not links[id] then
        links[id] = {}
        local key = ("%d %s"):format(message.report, source)
        open_queries[key] = open_queries[key] or {}
        open_queries[key][destination] = {frame = pinfo.number, id = id, time = pinfo.rel_ts}
    elseif message.query and not links[id] then
        links[id] = {}
        local asked = open_queries[("%d %s"):format(message.own_code, destination)] or {}
        for wanted, query in pairs(asked) do
            if matches(wanted, source) then
                links[id] = {query = query.frame, time = pinfo.rel_ts - query.time}
                links[query.id].report = links[query.id].report or pinfo.number
                if wanted == source then asked[wanted] = nil end
                break
            end
        end
    end
    local link = links[id]
    if not link then return end
    if link.report then tree:add(report_field, link.report):set_generated() end
    if link.query then
        tree:add(query_field, link.query):set_generated()
        local seconds = math.floor(link.time)
        tree:add(time_field, NSTime.new(seconds, math.floor((link.time - seconds) * 1e9))):set_generated()
    end
end
for _, list in ipairs({ra, sae, sae_1_0}) do
    for code, message in pairs(list) do message.own_code = code end
end

-- Large data sets and fragments ----------------------------------------------------------------------------------------

-- Packets that wait for others; per packet that was seen, the frame that completes it or the whole.
local open_sets, packet_results = {}, {}

-- Shows where a packet's message is complete; calls `dissect(bytes, first packet, frames)` where that is here.
-- `find_whole(key, packet)` adds the packet, and returns those of a complete message, in order.
local function reassemble(key, packet, pinfo, tree, find_whole, dissect)
    local id = table.concat({pinfo.number, key, packet.number, packet.flag}, " ")
    local result = packet_results[id]
    if not result then
        result = {}
        packet_results[id] = result
        packet.result, packet.frame, packet.time = result, pinfo.number, pinfo.rel_ts
        packet.bytes = packet.range and packet.range:bytes() or ByteArray.new()
        packet.range = nil
        local parts = find_whole(key, packet)
        if parts then
            result.whole, result.first, result.frames = ByteArray.new(), parts[1], {}
            for i, part in ipairs(parts) do
                result.whole:append(part.bytes)
                result.frames[i] = part.frame
                part.result.frame = pinfo.number
                part.bytes = nil
            end
        end
    end
    if result.frame then tree:add(whole_field, result.frame):set_generated() end
    if result.whole then dissect(result.whole, result.first, result.frames) end
end

-- RA 3.3: packets count from 0 in each data set of a source and code. A set that is silent for longer is another one.
local longest_gap = 0.125
local function add_to_data_set(key, packet)
    local set = open_sets[key]
    local held = set and set[packet.number]
    local differs = held and held.bytes:tohex() ~= packet.bytes:tohex()
    local is_new = set and packet.number == 0 and not held and packet.time - set.time > longest_gap
    if not set or differs or is_new then
        set = {}
        open_sets[key] = set
        held = nil
    end
    set.time = packet.time
    if held then return end
    set[packet.number] = packet
    if packet.is_last then set.last = packet.number end
    if not set.last then return end
    local parts = {}
    for number = 0, set.last do
        if not set[number] then return end
        parts[#parts + 1] = set[number]
    end
    open_sets[key] = nil
    return parts
end

-- SAE: packets of a message have consecutive sequence numbers. They repeat, so that old packets do not count.
local fragment_timeout = 10
local function add_fragment(key, packet)
    local set = open_sets[key] or {}
    open_sets[key] = set
    set[packet.number] = packet
    local function at(number)
        local found = set[number % 65536]
        return found and packet.time - found.time < fragment_timeout and found or nil
    end
    local first = packet.number
    while at(first) and at(first).place ~= "first" do first = first - 1 end
    local parts, number = {}, first
    while at(number) do
        parts[#parts + 1] = at(number)
        if at(number).place == "last" then
            for i = first, number do set[i % 65536] = nil end
            return parts
        end
        number = number + 1
    end
end

local function show_packets(tree, frames)
    for _, frame in ipairs(frames) do tree:add(packet_field, frame):set_generated() end
end

-- Whole messages ------------------------------------------------------------------------------------------------------

local function describe_in_columns(pinfo, title, source, destination)
    pinfo.cols.protocol = "JAUS"
    local is_first = tostring(pinfo.cols.info) == "" and not pinfo.private.jaus_described
    pinfo.cols.info:append((is_first and "" or "; ") .. ("%s, %s -> %s"):format(title, source, destination))
    pinfo.private.jaus_described = "yes" -- of a stream, the column does not tell
end

-- Of ack_nak.
local nak, ack = 2, 3

-- A message of RA 3.3, header first. `whole`: the packets of which it was made. `object`: the EtherCAT object that it is.
local function dissect_ra_message(tvb, begin, size, pinfo, root, framing, whole, object)
    local tree = root:add(jaus, tvb(begin, size))
    local data = {tvb = tvb, begin = begin, at = begin, limit = begin + size}
    if framing then tree:add(framing_field, framing):set_generated() end
    if object then tree:add(object_field, object):set_generated() end
    local head = guarded(read_structure, ra_header, data, tree)
    if not head then return end
    local source = structure_notations.address(head.source)
    local destination = structure_notations.address(head.destination)
    local message = ra[head.command_code]
    local title = message and message.title or ("command code 0x%04X"):format(head.command_code)
    tree:append_text((": %s, %s -> %s"):format(title, source, destination))
    local is_acknowledgement = (head.ack_nak == ack or head.ack_nak == nak)
    local body_size = data.limit - data.at
    if whole then show_packets(tree, whole.frames) end
    if head.data_flag ~= 0 and not whole and not is_acknowledgement and head.data_size == body_size then
        describe_in_columns(pinfo, title .. " (packet)", source, destination)
        local range = body_size > 0 and tvb(data.at, body_size) or nil
        if range then tree:add(body_field, range) end
        local packet = {number = head.sequence_number, flag = head.data_flag, is_last = head.data_flag == 8,
            range = range, header = tvb(begin, 16):bytes()}
        return reassemble(("RA %d %s"):format(head.command_code, source), packet, pinfo, tree, add_to_data_set,
            function(bytes, first, frames)
                -- The size of a large body does not fit its header: 0 where it does not.
                local header = ByteArray.new(first.header:tohex())
                local held = bytes:len() <= 4080 and bytes:len() or 0
                header:set_index(12, held % 256)
                header:set_index(13, math.floor(held / 256))
                header:append(bytes)
                dissect_ra_message(header:tvb("Reassembled JAUS message"), 0, header:len(), pinfo, root, nil,
                    {frames = frames})
            end)
    end
    describe_in_columns(pinfo, is_acknowledgement and title .. " (acknowledgement)" or title, source, destination)
    if not (is_acknowledgement and body_size == 0) then
        dissect_ra_body(head.command_code, data, tree)
        if message then link_query(message, source, destination, head.sequence_number, pinfo, tree) end
    end
    if not whole and head.data_size ~= body_size then
        tree:add_proto_expert_info(experts.malformed,
            ("Malformed: data_size is %d, %d bytes follow"):format(head.data_size, body_size))
    end
end

local sae_head_size, sae_overhead = 12, 14

-- A message of AS5669A, from its transport header on. Returns its size; nil where its end is not known.
local function dissect_sae_message(tvb, begin, limit, pinfo, root, whole, object)
    local left = limit - begin
    local size = left >= 3 and tvb(begin + 1, 2):le_uint() or 0
    local compression = math.floor(tvb(begin, 1):uint() / 64)
    local is_whole = left >= sae_overhead and size >= sae_overhead + (compression ~= 0 and 2 or 0) and size <= left
    local end_of_bytes = is_whole and begin + size or limit
    local tree = root:add(jaus, tvb(begin, end_of_bytes - begin))
    if object then tree:add(object_field, object):set_generated() end
    local own, at = tvb, begin
    if compression ~= 0 and left >= 5 then
        -- The two bytes behind the size are taken out, so that the header is the same.
        local number, length = tvb(begin + 3, 1), tvb(begin + 4, 1)
        tree:add(compression_number_field, number)
        tree:add(compression_length_field, length)
        local bytes = tvb(begin, 3):bytes()
        if end_of_bytes > begin + 5 then bytes:append(tvb(begin + 5, end_of_bytes - begin - 5):bytes()) end
        own, at = bytes:tvb("Without compression fields"), 0
        end_of_bytes = bytes:len()
    end
    local data = {tvb = own, begin = at, at = at, limit = end_of_bytes, is_sae = true}
    local head = guarded(read_structure, sae_header, data, tree)
    if not head then return end
    local source, destination = structure_notations.jaus_id(head.source), structure_notations.jaus_id(head.destination)
    if not is_whole and not whole then
        tree:add_proto_expert_info(experts.truncated, ("Truncated: the message states %d bytes, %d are there"):format(
            size, left))
        describe_in_columns(pinfo, "truncated message", source, destination)
        return
    end
    data.limit = end_of_bytes - 2
    local range = own(data.limit, 2)
    local number = range:le_uint()
    local payload_size = data.limit - data.at
    if whole then show_packets(tree, whole.frames) end
    local title
    if head.message_type ~= 0 or compression >= 2 then
        title = "message"
        tree:add_proto_expert_info(experts.unknown, compression >= 2 and "Unknown: the header is compressed" or
            ("Unknown: message type %d"):format(head.message_type))
    elseif head.fragment_flag ~= 0 and payload_size > 0 then
        title = "packet"
        tree:add(body_field, own(data.at, payload_size))
        local packet = {number = number, flag = head.fragment_flag, place = ({"first", "middle", "last"})[head.fragment_flag],
            range = own(data.at, payload_size), header = own(at, sae_head_size):bytes()}
        reassemble(("SAE %s %s"):format(source, destination), packet, pinfo, tree, add_fragment,
            function(bytes, first, frames)
                -- As a single packet: no fragment flag, no compression; 0 as size where it does not fit.
                local message = ByteArray.new(first.header:tohex())
                local held = bytes:len() + sae_overhead
                if held > 65535 then held = 0 end
                message:set_index(0, 0)
                message:set_index(1, held % 256)
                message:set_index(2, math.floor(held / 256))
                message:set_index(3, message:get_index(3) % 64)
                message:append(bytes)
                message:append(ByteArray.new(("%02x%02x"):format(first.number % 256, math.floor(first.number / 256))))
                dissect_sae_message(message:tvb("Reassembled JAUS message"), 0, message:len(), pinfo, root,
                    {frames = frames})
            end)
    elseif payload_size == 0 and head.acknowledgement >= 2 then
        title = "acknowledgement"
    elseif payload_size == 0 then
        title = "message without ID"
        tree:add_proto_expert_info(experts.truncated, "Truncated: no message ID")
    else
        local message = dissect_payload(data, tree)
        title = message and message.title or "unknown message"
        if message then link_query(message, source, destination, number, pinfo, tree) end
    end
    tree:add_le(sequence_number_field, range)
    tree:append_text((": %s, %s -> %s"):format(title, source, destination))
    describe_in_columns(pinfo, title, source, destination)
    return size
end

-- Datagrams and streams -------------------------------------------------------------------------------------------------

local function names_one_ra_component(tvb, at)
    for i = at, at + 3 do
        local part = tvb(i, 1):uint()
        if part == 0 or part == 255 then return false end
    end
    return true
end

-- Size of a message of AS5669-2007 without header compression, behind four bytes; nil where there is none.
local function judp1_size(tvb, at)
    if tvb:len() < at + 4 or tvb(at, 2):uint() ~= 0 then return end
    local size = tvb(at + 2, 2):uint()
    if size >= 16 and size <= tvb:len() - at - 4 then return size end
end

local function dissect_datagram(tvb, pinfo, root)
    local length = tvb:len()
    local begins_with = length >= 8 and tvb(0, 8):string() or ""
    if begins_with == "JAUS01.0" then
        if length == 8 then return 0 end
        dissect_ra_message(tvb, 8, length - 8, pinfo, root, "JAUS01.0")
        return length
    end
    if length > 5 and tvb(0, 1):uint() == 1 and judp1_size(tvb, 1) then
        local at = 1
        while at < length do
            local size = judp1_size(tvb, at)
            if not size then
                root:add(jaus, tvb(at)):add_proto_expert_info(experts.malformed, "Malformed: bytes behind the last message")
                break
            end
            dissect_ra_message(tvb, at + 4, size, pinfo, root, "AS5669-2007")
            at = at + 4 + size
        end
        return length
    end
    if length >= 15 and tvb(0, 1):uint() == 2 and tvb(1, 1):uint() % 64 == 0 then
        local is_component = tvb(9, 1):uint() % 255 ~= 0 and tvb(10, 1):uint() % 255 ~= 0 and
            tvb(11, 2):le_uint() % 65535 ~= 0
        if is_component then
            local at = 1
            while at < length do
                local size = dissect_sae_message(tvb, at, length, pinfo, root)
                if not size then break end
                at = at + size
            end
            return length
        end
    end
    if length < 16 or tvb(1, 1):uint() > 2 or not names_one_ra_component(tvb, 8) then return 0 end
    local size_matches = tvb(12, 2):le_uint() % 4096 == length - 16
    if not size_matches and not ra[tvb(2, 2):le_uint()] then return 0 end
    dissect_ra_message(tvb, 0, length, pinfo, root)
    return length
end

-- The first byte of a stream is the version, 2; that of a message is its type, which is 0.
local function before_message(tvb, at) return tvb(at, 1):uint() == 2 and 1 or 0 end

local function stream_message_size(tvb, _, at)
    local before = before_message(tvb, at)
    return before + math.max(tvb(at + before + 1, 2):le_uint(), 4)
end
local function dissect_stream_message(tvb, pinfo, root)
    dissect_sae_message(tvb, before_message(tvb, 0), tvb:len(), pinfo, root)
    return tvb:len()
end

local tcp = 2
function jaus.dissector(tvb, pinfo, root)
    if pinfo.port_type == tcp then
        if tvb:len() >= 1 and tvb(0, 1):uint() % 64 ~= 0 and tvb(0, 1):uint() ~= 2 then return 0 end
        pinfo.cols.info = ""
        dissect_tcp_pdus(tvb, root, 4, stream_message_size, dissect_stream_message)
        return tvb:len()
    end
    local info = tostring(pinfo.cols.info)
    pinfo.cols.info = ""
    local size = dissect_datagram(tvb, pinfo, root)
    if size == 0 then pinfo.cols.info = info end
    return size
end

DissectorTable.get("udp.port"):add(3794, jaus)
DissectorTable.get("tcp.port"):add(3794, jaus)

-- EtherCAT ---------------------------------------------------------------------------------------------------------------

-- What a mailbox carries is found in the bytes of the frame: Wireshark's own dissector has no table for it, and its fields
-- are there only where a tree is made.

local aprd, apwr, fprd, fpwr, bwr = 1, 2, 4, 5, 8
local station_address, al_control, process_ram = 0x0010, 0x0120, 0x1000
local mailbox_error, coe = 0, 3
local sdo_request, sdo_response = 2, 3

local mailboxes     -- by slave and direction: the last message, which each frame may show again
local stations      -- of slaves by their positions
local sent          -- commands by position, by the index of their datagrams
local transfers     -- that go on, by slave
local found_objects -- by frame

local function little_endian(bytes, at, size)
    local value = 0
    for i = size - 1, 0, -1 do value = value * 256 + bytes:get_index(at + i) end
    return value
end

local function component_of(object)
    local number = object.index - jaus.prefs.ethercat_index_base
    return number % 256, math.floor(number / 256)
end

local function is_message_object(object)
    local component, segment = component_of(object)
    local last_segment = jaus.prefs.ethercat_table == 4 and 15 or 0
    return jaus.prefs.ethercat_table ~= 5 and segment >= 0 and segment <= last_segment and component ~= 0 and
        object.subindex ~= 0 and not object.complete_access
end

local function bytes_of(...)
    local made = ""
    for _, byte in ipairs({...}) do made = made .. ("%02x"):format(byte) end
    return ByteArray.new(made)
end
local function part(bytes, at, size)
    return size > 0 and bytes:subset(at, size) or ByteArray.new()
end

-- The message of an object's data, as bytes; nil and the reason where they are none.
local function message_of(object)
    local data = object.data
    if jaus.prefs.ethercat_fixed_length then
        if data:len() < 2 then return nil, "no length" end
        local length = little_endian(data, 0, 2)
        if length > data:len() - 2 then return nil, ("the length is %d, %d bytes follow"):format(length, data:len() - 2) end
        data = part(data, 2, length)
    end
    local component, segment = component_of(object)
    local node = object.station and object.station < 255 and object.station or 0
    local size, kind = data:len(), jaus.prefs.ethercat_table
    if kind == 4 then
        local code = sae_ranks[segment + 1][object.subindex]
        if not code then return nil, "no message of the subindex" end
        if size < 9 then return nil, "shorter than the header" end
        local held = size + 7
        local made = bytes_of(0, held % 256, math.floor(held / 256), data:get_index(0), component, node,
            data:get_index(1), data:get_index(2))
        made:append(part(data, 3, 4))
        made:append(bytes_of(code % 256, math.floor(code / 256)))
        made:append(part(data, 7, size - 7))
        return made
    end
    local code = ra_ranks[object.subindex]
    if not code then return nil, "no message of the subindex" end
    local states_size = size >= 12 and little_endian(data, 8, 2) % 4096 == size - 12
    if kind == 1 then kind = states_size and 3 or 2 end
    if kind == 3 and not states_size then return nil, "the stated size is another" end
    if size < 8 then return nil, "shorter than the header" end
    local made = part(data, 0, 2)
    made:append(bytes_of(code % 256, math.floor(code / 256)))
    if kind == 3 then
        made:append(bytes_of(data:get_index(2), component, node, data:get_index(3)))
        made:append(part(data, 4, size - 4))
        return made
    end
    local body = size - 8
    made:append(bytes_of(1, component, node, jaus.prefs.ethercat_subsystem))
    made:append(part(data, 2, 4))
    made:append(bytes_of(body % 256, math.floor(body / 256)))
    made:append(part(data, 6, size - 6))
    return made
end

local function carry(object, frame)
    if is_message_object(object) then table.insert(found_objects[frame], {object = object}) end
end

local function begin_transfer(slave, sdo, is_download)
    transfers[slave.name] = nil
    if sdo:len() < 8 then return end
    local command = sdo:get_index(0)
    local object = {slave = slave.name, station = slave.station, download = is_download,
        index = little_endian(sdo, 1, 2), subindex = sdo:get_index(3), complete_access = has_bit(command, 4),
        data = ByteArray.new()}
    local transfer = {object = object, toggle = false}
    transfers[slave.name] = transfer
    return transfer
end

local function take_initial(slave, transfer, sdo, frame)
    local command, object = sdo:get_index(0), transfer.object
    local expedited, size_indicated = has_bit(command, 1), has_bit(command, 0)
    if expedited then
        local unused = size_indicated and math.floor(command / 4) % 4 or 0
        object.data = part(sdo, 4, 4 - unused)
        transfer.size = object.data:len()
    else
        local size, held = little_endian(sdo, 4, 4), sdo:len() - 8
        if not size_indicated and size < held then size = held end -- some masters leave the size out: this is all
        object.data = part(sdo, 8, math.min(held, size))
        transfer.size = size
    end
    transfer.is_open = object.data:len() < transfer.size
    transfer.in_segments = transfer.is_open
    if transfer.is_open then return end
    carry(object, frame)
    if not object.download then transfers[slave.name] = nil end
end

local function take_segment(slave, sdo, is_download, frame)
    local transfer = transfers[slave.name]
    if not transfer or not transfer.is_open or transfer.object.download ~= is_download then return end
    local command = sdo:get_index(0)
    local held = sdo:len() - 1
    if held <= 7 then held = math.min(held, 7 - math.floor(command / 2) % 8) end
    local data = transfer.object.data
    local is_last, size = has_bit(command, 0), data:len() + held
    local fits = is_last and size == transfer.size or not is_last and size <= transfer.size
    if has_bit(command, 4) ~= transfer.toggle or not fits then
        transfers[slave.name] = nil
        return
    end
    data:append(part(sdo, 1, held))
    transfer.toggle = not transfer.toggle
    if not is_last then return end
    transfer.is_open = false
    carry(transfer.object, frame)
    if not is_download then transfers[slave.name] = nil end
end

local function names_object(sdo, transfer)
    return sdo:len() >= 4 and little_endian(sdo, 1, 2) == transfer.object.index and
        sdo:get_index(3) == transfer.object.subindex
end

local function refuse(slave, text, frame)
    local transfer = transfers[slave.name]
    transfers[slave.name] = nil
    if transfer and is_message_object(transfer.object) then
        table.insert(found_objects[frame], {object = transfer.object, refused = text})
    end
end

local function take_abort(slave, sdo, frame)
    local transfer = transfers[slave.name]
    if sdo:len() < 8 or not transfer or not (transfer.in_segments or names_object(sdo, transfer)) then return end
    refuse(slave, ("SDO abort 0x%04X%04X"):format(little_endian(sdo, 6, 2), little_endian(sdo, 4, 2)), frame)
end

local function confirm(slave, transfer)
    if transfer and transfer.object.download and not transfer.is_open then transfers[slave.name] = nil end
end

local function take_sdo(slave, to_slave, sdo, frame)
    if sdo:len() < 1 then return end
    local specifier, transfer = math.floor(sdo:get_index(0) / 32), transfers[slave.name]
    if specifier == 4 then
        take_abort(slave, sdo, frame)
    elseif to_slave and specifier == 1 then
        local begun = begin_transfer(slave, sdo, true)
        if begun then take_initial(slave, begun, sdo, frame) end
    elseif to_slave and specifier == 2 then
        begin_transfer(slave, sdo, false)
    elseif to_slave and specifier == 0 then
        take_segment(slave, sdo, true, frame)
    elseif specifier == 2 then
        local is_expected = transfer and not transfer.object.download and names_object(sdo, transfer)
        local begun = is_expected and transfer or begin_transfer(slave, sdo, false)
        if begun and sdo:len() >= 8 then take_initial(slave, begun, sdo, frame) end
    elseif specifier == 0 then
        take_segment(slave, sdo, false, frame)
    elseif specifier == 3 and transfer and names_object(sdo, transfer) or specifier == 1 then
        confirm(slave, transfer)
    end
end

local function take_mailbox_message(slave, to_slave, message, frame)
    local kind = message:get_index(5) % 16
    local size = message:len() - 6
    if kind == mailbox_error and not to_slave and size >= 4 then
        refuse(slave, ("mailbox error 0x%04X"):format(little_endian(message, 8, 2)), frame)
    elseif kind == coe and size > 2 then
        local service = math.floor(message:get_index(7) / 16)
        if service == sdo_request or service == sdo_response then -- some slaves abort by a request
            take_sdo(slave, to_slave, part(message, 8, size - 2), frame)
        end
    end
end

local function position_of(datagram)
    local out = sent[datagram.index]
    local is_same = out and out.command == datagram.command and out.ado == datagram.ado
    return (65536 - (is_same and out.adp or datagram.adp)) % 65536
end

local function slave_of(datagram)
    if datagram.command == fprd or datagram.command == fpwr then
        return {name = ("station %d"):format(datagram.adp), station = datagram.adp}
    end
    local position = position_of(datagram)
    local station = stations[position]
    if station then return {name = ("station %d"):format(station), station = station} end
    return {name = ("position %d"):format(position)}
end

-- Registers with the identity of a slave, or that reset its mailbox.
local function note_setup(datagram)
    if datagram.command == apwr and datagram.ado == station_address and datagram.data:len() >= 2 then
        stations[position_of(datagram)] = little_endian(datagram.data, 0, 2)
    elseif datagram.ado == al_control and datagram.command == bwr then
        mailboxes = {}
    elseif datagram.ado == al_control and (datagram.command == apwr or datagram.command == fpwr) then
        local name = slave_of(datagram).name
        mailboxes[name .. " true"], mailboxes[name .. " false"] = nil, nil
    end
end

local function take_datagram(datagram, frame)
    local command, is_executed = datagram.command, datagram.working_counter ~= 0
    if not is_executed then
        if command == aprd or command == apwr then sent[datagram.index] = datagram end
        return
    end
    if datagram.ado < process_ram then return note_setup(datagram) end
    local to_slave = command == apwr or command == fpwr
    if not to_slave and command ~= aprd and command ~= fprd then return end
    local data = datagram.data
    if data:len() < 7 then return end
    local length = little_endian(data, 0, 2)
    if length < 1 or length > data:len() - 6 then return end
    local message, slave = part(data, 0, 6 + length), slave_of(datagram)
    local key = slave.name .. " " .. tostring(to_slave)
    local last, hex = mailboxes[key], message:tohex()
    -- A sender that counts gives each message another counter than the one before.
    local counter = math.floor(message:get_index(5) / 16) % 8
    if last and last.hex == hex and (counter ~= 0 or last.index == datagram.index) then return end
    mailboxes[key] = {hex = hex, index = datagram.index}
    take_mailbox_message(slave, to_slave, message, frame)
end

-- The datagrams of a frame, in the first pass over it.
local function take_frame(tvb, frame)
    local at = 0
    while at + 12 <= tvb:len() do
        local word = tvb(at + 6, 2):le_uint()
        local size = word % 2048
        if at + 12 + size > tvb:len() then return end
        take_datagram({command = tvb(at, 1):uint(), index = tvb(at + 1, 1):uint(), adp = tvb(at + 2, 2):le_uint(),
            ado = tvb(at + 4, 2):le_uint(), data = size > 0 and tvb(at + 10, size):bytes() or ByteArray.new(),
            working_counter = tvb(at + 10 + size, 2):le_uint()}, frame)
        if word < 32768 then return end
        at = at + 12 + size
    end
end

local function show_object(found, pinfo, root)
    local object = found.object
    local bytes, why = message_of(object)
    local text = ("0x%04X:%d, %s %s"):format(object.index, object.subindex, object.download and "download to" or
        "upload from", object.slave)
    local tree
    if found.refused then
        local code = jaus.prefs.ethercat_table ~= 4 and ra_ranks[object.subindex]
        tree = root:add(jaus, "JAUS: message in EtherCAT object " .. text)
        if code then tree:add(command_code_field, code):set_generated() end
        tree:add_proto_expert_info(experts.refused, "Refused: " .. found.refused)
        pinfo.cols.info:append("refused: object " .. text)
    elseif not bytes then
        tree = root:add(jaus, "JAUS: EtherCAT object " .. text)
        if object.data:len() > 0 then
            local tvb = object.data:tvb("JAUS object")
            tree:add(body_field, tvb())
        end
        tree:add_proto_expert_info(experts.malformed, "Malformed: no message: " .. why)
        pinfo.cols.info:append("no message: object " .. text)
    else
        local tvb = bytes:tvb("JAUS message")
        if jaus.prefs.ethercat_table == 4 then
            dissect_sae_message(tvb, 0, tvb:len(), pinfo, root, nil, text)
        else
            dissect_ra_message(tvb, 0, tvb:len(), pinfo, root, nil, nil, text)
        end
    end
end

local ethercat = Proto("jaus_ethercat", "JAUS over EtherCAT")
local frame_types = DissectorTable.get("ecatf.type")
local commands = 1
local wiresharks_own = frame_types:get_dissector(commands)

function ethercat.dissector(tvb, pinfo, root)
    local size = wiresharks_own:call(tvb, pinfo, root)
    local frame = pinfo.number
    if not found_objects[frame] then
        found_objects[frame] = {}
        take_frame(tvb, frame)
    end
    if #found_objects[frame] ~= 0 then
        pinfo.cols.protocol = "JAUS"
        pinfo.cols.info = ""
    end
    for _, found in ipairs(found_objects[frame]) do show_object(found, pinfo, root) end
    return size
end
frame_types:set(commands, ethercat)

function jaus.init()
    open_queries, links, open_sets, packet_results = {}, {}, {}, {}
    mailboxes, stations, sent, transfers, found_objects = {}, {}, {}, {}, {}
end
