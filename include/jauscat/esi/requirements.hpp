// Requirements on an ESI file, as tables: elements and attributes, and the order of elements. Sources: the schema
// EtherCATInfo.xsd (version 1.19 of ETG.2000), the content that tools write to the SII (ETG.2010), and the content that
// emulators read for the dictionary.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace jauscat::esi {

/// Required content of an element or attribute.
enum class content : std::uint8_t {
    element,      ///< anything
    text,         ///< any text
    number,       ///< `#x1A` or `26`
    boolean,      ///< `true`, `false`, `1` or `0`
    bytes,        ///< hexadecimal digits, two for each byte
    access,       ///< `ro`, `wo` or `rw`
    sync_manager, ///< `MBoxOut`, `MBoxIn`, `Outputs` or `Inputs`
};

/// Who requires something.
enum class demand : std::uint8_t {
    schema,    ///< without it, the file is no ESI file, or it contradicts itself
    standard,  ///< configuration tools use it, and do with less without it
    emulation, ///< the emulated device needs it
};

/// Where something is required.
enum class needed : std::uint8_t {
    always,       ///< and so at least one parent
    with_mailbox, ///< in a device with a mailbox, and so at least one parent
    with_coe,     ///< in a device whose mailbox has CoE, and so at least one parent
    in_parent,    ///< in each parent that exists
};

/// One required element, or attribute if the last step begins with @.
struct requirement {
    std::string_view path{}; ///< below EtherCATInfo
    content holds{};         ///< required content
    needed where{};
    demand by{};
    std::string_view reason{}; ///< what it is for
};

// clang-format off
/// Elements and attributes that an ESI file must have.
inline constexpr std::array requirements{
    requirement{"Vendor", content::element, needed::always, demand::schema, "who makes the devices"},
    requirement{"Vendor/Id", content::number, needed::always, demand::schema, "SII words 8 and 9, object 1018h:1"},
    requirement{"Vendor/Name", content::text, needed::always, demand::schema, "shown in the list of devices"},
    requirement{"Descriptions", content::element, needed::always, demand::schema, "holds the devices"},
    requirement{"Descriptions/Groups", content::element, needed::always, demand::schema, "devices are listed by group"},
    requirement{"Descriptions/Groups/Group", content::element, needed::always, demand::schema, "devices are listed by group"},
    requirement{"Descriptions/Groups/Group/Type", content::text, needed::always, demand::schema, "key of the group"},
    requirement{"Descriptions/Groups/Group/Name", content::text, needed::always, demand::schema, "shown in the list of devices"},
    requirement{"Descriptions/Devices", content::element, needed::always, demand::schema, "holds the devices"},
    requirement{"Descriptions/Devices/Device", content::element, needed::always, demand::schema, "what the file describes"},
    requirement{"Descriptions/Devices/Device/@Physics", content::text, needed::always, demand::schema, "SII, kind of each port"},
    requirement{"Descriptions/Devices/Device/Type", content::text, needed::always, demand::schema, "SII, order number"},
    requirement{"Descriptions/Devices/Device/Type/@ProductCode", content::number, needed::always, demand::standard, "SII words 0Ah and 0Bh; by it a tool finds the file of a device"},
    requirement{"Descriptions/Devices/Device/Type/@RevisionNo", content::number, needed::always, demand::standard, "SII words 0Ch and 0Dh; by it a tool finds the file of a device"},
    requirement{"Descriptions/Devices/Device/Name", content::text, needed::always, demand::schema, "SII, name"},
    requirement{"Descriptions/Devices/Device/GroupType", content::text, needed::always, demand::schema, "names a group of this file"},
    requirement{"Descriptions/Devices/Device/Profile", content::element, needed::with_coe, demand::emulation, "holds the dictionary"},
    requirement{"Descriptions/Devices/Device/Profile/ProfileNo", content::number, needed::with_coe, demand::emulation, "low word of object 1000h"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary", content::element, needed::with_coe, demand::emulation, "the offline dictionary: without SDO information the only one"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes", content::element, needed::with_coe, demand::emulation, "types of the objects"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType", content::element, needed::with_coe, demand::emulation, "types of the objects"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType/Name", content::text, needed::in_parent, demand::schema, "names it"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType/BitSize", content::number, needed::in_parent, demand::schema, "its size"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType/ArrayInfo/LBound", content::number, needed::in_parent, demand::schema, "its first subindex"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType/ArrayInfo/Elements", content::number, needed::in_parent, demand::schema, "their number"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType/SubItem/Name", content::text, needed::in_parent, demand::schema, "names it"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType/SubItem/Type", content::text, needed::in_parent, demand::schema, "its type"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType/SubItem/BitSize", content::number, needed::in_parent, demand::schema, "its size"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType/SubItem/BitOffs", content::number, needed::in_parent, demand::schema, "its place"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType/SubItem/Flags", content::element, needed::in_parent, demand::standard, "without it an entry is read only"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/DataTypes/DataType/SubItem/Flags/Access", content::access, needed::in_parent, demand::standard, "without it an entry is read only"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/Objects", content::element, needed::with_coe, demand::emulation, "the objects of the dictionary"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/Objects/Object", content::element, needed::with_coe, demand::emulation, "the objects of the dictionary"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/Objects/Object/Index", content::number, needed::in_parent, demand::schema, "its place"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/Objects/Object/Name", content::text, needed::in_parent, demand::schema, "names it"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/Objects/Object/Type", content::text, needed::in_parent, demand::schema, "its type"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/Objects/Object/BitSize", content::number, needed::in_parent, demand::schema, "its size"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/Objects/Object/Info", content::element, needed::with_coe, demand::emulation, "emulators look for default values in it"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/Objects/Object/Info/SubItem/Name", content::text, needed::in_parent, demand::schema, "names it"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/Objects/Object/Info/SubItem/Info", content::element, needed::in_parent, demand::schema, "emulators look for default values in it"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/Objects/Object/Flags", content::element, needed::in_parent, demand::standard, "without it a variable is read only"},
    requirement{"Descriptions/Devices/Device/Profile/Dictionary/Objects/Object/Flags/Access", content::access, needed::in_parent, demand::standard, "without it a variable is read only"},
    requirement{"Descriptions/Devices/Device/Sm", content::sync_manager, needed::with_mailbox, demand::standard, "SII, category SyncM; object 1C00h"},
    requirement{"Descriptions/Devices/Device/Sm/@StartAddress", content::number, needed::in_parent, demand::schema, "SII, mailbox and category SyncM"},
    requirement{"Descriptions/Devices/Device/Sm/@DefaultSize", content::number, needed::in_parent, demand::standard, "SII, mailbox and category SyncM"},
    requirement{"Descriptions/Devices/Device/Sm/@ControlByte", content::number, needed::in_parent, demand::standard, "SII, category SyncM; one without a place in the SII has none"},
    requirement{"Descriptions/Devices/Device/Sm/@Enable", content::number, needed::in_parent, demand::standard, "SII, category SyncM; one without a place in the SII has none"},
    requirement{"Descriptions/Devices/Device/RxPdo/Index", content::number, needed::in_parent, demand::schema, "SII, category RxPDO"},
    requirement{"Descriptions/Devices/Device/RxPdo/Name", content::text, needed::in_parent, demand::schema, "SII, category RxPDO"},
    requirement{"Descriptions/Devices/Device/RxPdo/Entry/Index", content::number, needed::in_parent, demand::schema, "SII, category RxPDO"},
    requirement{"Descriptions/Devices/Device/RxPdo/Entry/BitLen", content::number, needed::in_parent, demand::schema, "SII, category RxPDO"},
    requirement{"Descriptions/Devices/Device/TxPdo/Index", content::number, needed::in_parent, demand::schema, "SII, category TxPDO"},
    requirement{"Descriptions/Devices/Device/TxPdo/Name", content::text, needed::in_parent, demand::schema, "SII, category TxPDO"},
    requirement{"Descriptions/Devices/Device/TxPdo/Entry/Index", content::number, needed::in_parent, demand::schema, "SII, category TxPDO"},
    requirement{"Descriptions/Devices/Device/TxPdo/Entry/BitLen", content::number, needed::in_parent, demand::schema, "SII, category TxPDO"},
    requirement{"Descriptions/Devices/Device/Mailbox", content::element, needed::with_mailbox, demand::standard, "SII word 1Ch, mailbox protocols"},
    requirement{"Descriptions/Devices/Device/Mailbox/CoE", content::element, needed::with_coe, demand::standard, "SII word 1Ch and category general: SDO transfers"},
    requirement{"Descriptions/Devices/Device/Mailbox/CoE/@SdoInfo", content::boolean, needed::in_parent, demand::standard, "whether a tool asks the device or this file for the dictionary"},
    requirement{"Descriptions/Devices/Device/Mailbox/CoE/@CompleteAccess", content::boolean, needed::in_parent, demand::standard, "how a tool writes whole objects"},
    requirement{"Descriptions/Devices/Device/Mailbox/CoE/@SegmentedSdo", content::boolean, needed::in_parent, demand::standard, "whether an object may be larger than the mailbox"},
    requirement{"Descriptions/Devices/Device/Dc/OpMode/Name", content::text, needed::in_parent, demand::schema, "SII, category DC; a tool offers it by name"},
    requirement{"Descriptions/Devices/Device/Dc/OpMode/AssignActivate", content::number, needed::in_parent, demand::schema, "SII, category DC; registers 0980h and 0981h"},
    requirement{"Descriptions/Devices/Device/Eeprom", content::element, needed::always, demand::standard, "a tool writes the SII from it"},
    requirement{"Descriptions/Devices/Device/Eeprom/ByteSize", content::number, needed::always, demand::standard, "SII word 3Eh"},
    requirement{"Descriptions/Devices/Device/Eeprom/ConfigData", content::bytes, needed::always, demand::standard, "SII words 0 to 6"},
};

/// The permitted children of an element, in order.
struct element_order {
    std::string_view kind{};     ///< of the element
    std::string_view children{}; ///< names, separated by spaces; with `:kind` where the order in it is known, too
};

/// The order of the elements that the schema prescribes, from the root.
inline constexpr std::array element_orders{
    element_order{"EtherCATInfo", "InfoReference Vendor:Vendor Descriptions:Descriptions"},
    element_order{"Vendor", "Id Name Comment URL DescriptionURL Image16x14 ImageFile16x14 ImageData16x14 VendorSpecific"},
    element_order{"Descriptions", "Groups:Groups Devices:Devices Modules:Modules"},
    element_order{"Groups", "Group:Group"},
    element_order{"Group", "Type Name Comment Image16x14 ImageFile16x14 ImageData16x14 VendorSpecific"},
    element_order{"Devices", "Device:Device"},
    element_order{"Device", "Sci Type HideType AlternativeType SubDevice Name Comment URL Info GroupType Profile:Profile Fmmu Sm Su "
                            "RxPdo:Pdo TxPdo:Pdo Mailbox:Mailbox Dc:Dc Slots ESC Eeprom:Eeprom Image16x14 ImageFile16x14 "
                            "ImageData16x14 VendorSpecific"},
    element_order{"Modules", "Module:Module"},
    element_order{"Module", "Type Name RxPdo:Pdo TxPdo:Pdo Mailbox DcSettingsMandatory Profile:Profile Comment ImageFile16x14 "
                            "ImageData16x14 VendorSpecific"},
    element_order{"Profile", "ProfileNo AddInfo SubAddInfo ChannelCount ChannelInfo DictionaryFile Dictionary:Dictionary DiagFile "
                             "DiagMessages VendorSpecific"},
    element_order{"Dictionary", "UnitTypes DataTypes:DataTypes Objects:Objects"},
    element_order{"DataTypes", "DataType:DataType"},
    element_order{"DataType", "Index Name BaseType Comment BitSize ArrayInfo:ArrayInfo SubItem:TypeItem EnumInfo Properties:Properties "
                              "Xml"},
    element_order{"ArrayInfo", "LBound Elements"},
    element_order{"TypeItem", "SubIdx Name DisplayName Type Comment BitSize BitOffs DefaultString DefaultData Flags:Flags Property "
                              "Xml"},
    element_order{"Objects", "Object:Object"},
    element_order{"Object", "Index Name Comment Type BitSize Info Flags:Flags Properties:Properties Xml"},
    element_order{"Flags", "Access Category PdoMapping SafetyMapping Attribute Transition SdoAccess Backup Setting"},
    element_order{"Properties", "Property"},
    element_order{"Pdo", "Index Name Exclude ExcludedSm Entry:Entry"},
    element_order{"Entry", "Index SubIndex BitLen Name Comment DataType"},
    element_order{"Mailbox", "AoE EoE CoE FoE SoE VoE VendorSpecific"},
    element_order{"Dc", "OpMode:OpMode VendorSpecific"},
    element_order{"OpMode", "Name Desc AssignActivate CycleTimeSync0 ShiftTimeSync0 CycleTimeSync1 ShiftTimeSync1 "
                            "CycleTimeSync2 ShiftTimeSync2 CycleTimeSync3 ShiftTimeSync3 Sm VendorSpecific"},
    element_order{"Eeprom", "Data ByteSize ConfigData BootStrap Category VendorSpecific"},
};
// clang-format on

} // namespace jauscat::esi
