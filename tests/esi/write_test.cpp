// The ESI document, literally.
#include "esi/sample.hpp"
#include "support/catch.hpp"
#include <jauscat/esi/text_values.hpp>

using namespace jauscat;

TEST_CASE("the document of a slave with one component equals the expected text") {
    constexpr std::array components{bridging::object_list<translation::seed_table, 33, jaus::report_wrench_effort,
                                                          jaus::set_wrench_effort>::description};
    const auto device = esi::make_device(test::sample_slave, test::sample_texts, components, false);
    CHECK(esi::write_esi(device) == R"(<?xml version="1.0" encoding="UTF-8"?>
<EtherCATInfo xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="EtherCATInfo.xsd" Version="1.6">
  <Vendor>
    <Id>#x000006A5</Id>
    <Name LcId="1033">Makers &amp; Co</Name>
  </Vendor>
  <Descriptions>
    <Groups>
      <Group>
        <Type>arms</Type>
        <Name LcId="1033">Robot arms</Name>
      </Group>
    </Groups>
    <Devices>
      <Device Physics="YY">
        <Type ProductCode="#x00000021" RevisionNo="#x00010002">A-1</Type>
        <Name LcId="1033">arm &lt;1&gt;</Name>
        <GroupType>arms</GroupType>
        <Profile>
          <ProfileNo>0</ProfileNo>
          <Dictionary>
            <DataTypes>
              <DataType>
                <Name>UDINT</Name>
                <BitSize>32</BitSize>
              </DataType>
              <DataType>
                <Name>STRING(7)</Name>
                <BitSize>56</BitSize>
              </DataType>
              <DataType>
                <Name>USINT</Name>
                <BitSize>8</BitSize>
              </DataType>
              <DataType>
                <Name>DT1018</Name>
                <BitSize>144</BitSize>
                <SubItem>
                  <SubIdx>0</SubIdx>
                  <Name>Highest subindex</Name>
                  <Type>USINT</Type>
                  <BitSize>8</BitSize>
                  <BitOffs>0</BitOffs>
                  <Flags>
                    <Access>ro</Access>
                  </Flags>
                </SubItem>
                <SubItem>
                  <SubIdx>1</SubIdx>
                  <Name>Vendor ID</Name>
                  <Type>UDINT</Type>
                  <BitSize>32</BitSize>
                  <BitOffs>16</BitOffs>
                  <Flags>
                    <Access>ro</Access>
                  </Flags>
                </SubItem>
                <SubItem>
                  <SubIdx>2</SubIdx>
                  <Name>Product code</Name>
                  <Type>UDINT</Type>
                  <BitSize>32</BitSize>
                  <BitOffs>48</BitOffs>
                  <Flags>
                    <Access>ro</Access>
                  </Flags>
                </SubItem>
                <SubItem>
                  <SubIdx>3</SubIdx>
                  <Name>Revision</Name>
                  <Type>UDINT</Type>
                  <BitSize>32</BitSize>
                  <BitOffs>80</BitOffs>
                  <Flags>
                    <Access>ro</Access>
                  </Flags>
                </SubItem>
                <SubItem>
                  <SubIdx>4</SubIdx>
                  <Name>Serial number</Name>
                  <Type>UDINT</Type>
                  <BitSize>32</BitSize>
                  <BitOffs>112</BitOffs>
                  <Flags>
                    <Access>ro</Access>
                  </Flags>
                </SubItem>
              </DataType>
              <DataType>
                <Name>DT1C00ARR</Name>
                <BaseType>USINT</BaseType>
                <BitSize>16</BitSize>
                <ArrayInfo>
                  <LBound>1</LBound>
                  <Elements>2</Elements>
                </ArrayInfo>
              </DataType>
              <DataType>
                <Name>DT1C00</Name>
                <BitSize>32</BitSize>
                <SubItem>
                  <SubIdx>0</SubIdx>
                  <Name>Highest subindex</Name>
                  <Type>USINT</Type>
                  <BitSize>8</BitSize>
                  <BitOffs>0</BitOffs>
                  <Flags>
                    <Access>ro</Access>
                  </Flags>
                </SubItem>
                <SubItem>
                  <Name>Elements</Name>
                  <Type>DT1C00ARR</Type>
                  <BitSize>16</BitSize>
                  <BitOffs>16</BitOffs>
                  <Flags>
                    <Access>ro</Access>
                  </Flags>
                </SubItem>
              </DataType>
              <DataType>
                <Name>OCTET_STRING(28)</Name>
                <BitSize>224</BitSize>
              </DataType>
              <DataType>
                <Name>DT1B15</Name>
                <BitSize>464</BitSize>
                <SubItem>
                  <SubIdx>0</SubIdx>
                  <Name>Highest subindex</Name>
                  <Type>USINT</Type>
                  <BitSize>8</BitSize>
                  <BitOffs>0</BitOffs>
                  <Flags>
                    <Access>ro</Access>
                  </Flags>
                </SubItem>
                <SubItem>
                  <SubIdx>26</SubIdx>
                  <Name>set_wrench_effort</Name>
                  <Type>OCTET_STRING(28)</Type>
                  <BitSize>224</BitSize>
                  <BitOffs>16</BitOffs>
                  <Flags>
                    <Access>wo</Access>
                  </Flags>
                  <Property>
                    <Name>JausCommandCode</Name>
                    <Value>#x0405</Value>
                  </Property>
                </SubItem>
                <SubItem>
                  <SubIdx>121</SubIdx>
                  <Name>report_wrench_effort</Name>
                  <Type>OCTET_STRING(28)</Type>
                  <BitSize>224</BitSize>
                  <BitOffs>240</BitOffs>
                  <Flags>
                    <Access>rw</Access>
                  </Flags>
                  <Property>
                    <Name>JausCommandCode</Name>
                    <Value>#x4405</Value>
                  </Property>
                </SubItem>
              </DataType>
            </DataTypes>
            <Objects>
              <Object>
                <Index>#x1000</Index>
                <Name LcId="1033">Device type</Name>
                <Type>UDINT</Type>
                <BitSize>32</BitSize>
                <Info>
                  <DefaultData>00000000</DefaultData>
                </Info>
                <Flags>
                  <Access>ro</Access>
                  <Category>m</Category>
                </Flags>
              </Object>
              <Object>
                <Index>#x1008</Index>
                <Name LcId="1033">Device name</Name>
                <Type>STRING(7)</Type>
                <BitSize>56</BitSize>
                <Info>
                  <DefaultData>61726D203C313E</DefaultData>
                </Info>
                <Flags>
                  <Access>ro</Access>
                  <Category>o</Category>
                </Flags>
              </Object>
              <Object>
                <Index>#x1018</Index>
                <Name LcId="1033">Identity</Name>
                <Type>DT1018</Type>
                <BitSize>144</BitSize>
                <Info>
                  <SubItem>
                    <Name>Highest subindex</Name>
                    <Info>
                      <DefaultData>04</DefaultData>
                    </Info>
                  </SubItem>
                  <SubItem>
                    <Name>Vendor ID</Name>
                    <Info>
                      <DefaultData>A5060000</DefaultData>
                    </Info>
                  </SubItem>
                  <SubItem>
                    <Name>Product code</Name>
                    <Info>
                      <DefaultData>21000000</DefaultData>
                    </Info>
                  </SubItem>
                  <SubItem>
                    <Name>Revision</Name>
                    <Info>
                      <DefaultData>02000100</DefaultData>
                    </Info>
                  </SubItem>
                  <SubItem>
                    <Name>Serial number</Name>
                    <Info>
                      <DefaultData>00000000</DefaultData>
                    </Info>
                  </SubItem>
                </Info>
                <Flags>
                  <Access>ro</Access>
                  <Category>m</Category>
                </Flags>
              </Object>
              <Object>
                <Index>#x1C00</Index>
                <Name LcId="1033">SyncManager types</Name>
                <Type>DT1C00</Type>
                <BitSize>32</BitSize>
                <Info>
                  <SubItem>
                    <Name>Highest subindex</Name>
                    <Info>
                      <DefaultData>02</DefaultData>
                    </Info>
                  </SubItem>
                  <SubItem>
                    <Name>SyncManager 0</Name>
                    <Info>
                      <DefaultData>01</DefaultData>
                    </Info>
                  </SubItem>
                  <SubItem>
                    <Name>SyncManager 1</Name>
                    <Info>
                      <DefaultData>02</DefaultData>
                    </Info>
                  </SubItem>
                </Info>
                <Flags>
                  <Access>ro</Access>
                  <Category>m</Category>
                </Flags>
              </Object>
              <Object>
                <Index>#x1B15</Index>
                <Name LcId="1033">component 33</Name>
                <Type>DT1B15</Type>
                <BitSize>464</BitSize>
                <Info>
                  <SubItem>
                    <Name>Highest subindex</Name>
                    <Info>
                      <DefaultData>79</DefaultData>
                    </Info>
                  </SubItem>
                  <SubItem>
                    <Name>set_wrench_effort</Name>
                    <Info />
                  </SubItem>
                  <SubItem>
                    <Name>report_wrench_effort</Name>
                    <Info />
                  </SubItem>
                </Info>
                <Flags>
                  <Access>rw</Access>
                  <Category>o</Category>
                </Flags>
                <Properties>
                  <Property>
                    <Name>JausComponent</Name>
                    <Value>33</Value>
                  </Property>
                </Properties>
              </Object>
            </Objects>
          </Dictionary>
        </Profile>
        <Sm DefaultSize="256" StartAddress="#x1000" ControlByte="#x26" Enable="1">MBoxOut</Sm>
        <Sm DefaultSize="256" StartAddress="#x1600" ControlByte="#x22" Enable="1">MBoxIn</Sm>
        <Mailbox DataLinkLayer="true">
          <CoE SdoInfo="true" PdoAssign="false" PdoConfig="false" CompleteAccess="true" SegmentedSdo="false" />
        </Mailbox>
        <Eeprom>
          <ByteSize>512</ByteSize>
          <ConfigData>8000000000000000341200000000</ConfigData>
        </Eeprom>
      </Device>
    </Devices>
  </Descriptions>
</EtherCATInfo>
)");
}

TEST_CASE("numbers are written as the schema's HexDecValue") {
    CHECK(esi::hex_number(0) == "#x0");
    CHECK(esi::hex_number(0x1A) == "#x1A");
    CHECK(esi::hex_number(0x1A, 4) == "#x001A");
    CHECK(esi::hex_number(0xFFFFFFFF, 8) == "#xFFFFFFFF");
    CHECK(esi::parse_number("#x1a") == 26);
    CHECK(esi::parse_number("26") == 26);
    CHECK(esi::parse_number("#xFFFFFFFF") == 0xFFFFFFFF);
    CHECK(!esi::parse_number("#x100000000"));
    CHECK(!esi::parse_number("256", 255));
    for (const auto* wrong : {"", "#x", "0x1A", "1A", "-1", "1 ", " 1", "#x1G"}) CHECK(!esi::parse_number(wrong));
}

TEST_CASE("the sizes of base types are those of ETG.1020") {
    CHECK(esi::bits_of("BOOL") == 1);
    CHECK(esi::bits_of("USINT") == 8);
    CHECK(esi::bits_of("UINT") == 16);
    CHECK(esi::bits_of("UDINT") == 32);
    CHECK(esi::bits_of("LREAL") == 64);
    CHECK(esi::bits_of("STRING(7)") == 56);
    CHECK(esi::bits_of("OCTET_STRING(1544)") == 12352);
    CHECK(esi::bits_of("ARRAY [0..27] OF BYTE") == 224);
    CHECK(esi::bits_of("ARRAY [0..27] OF INT") == 448);
    CHECK(esi::bits_of("VISIBLE_STRING(7)") == 56);
    CHECK(esi::bits_of("UNICODE_STRING(7)") == 112);
    CHECK(esi::bits_of("BITARR16") == 16);
    for (const auto* wrong : {"", "usint", "DT1018", "STRING()", "STRING(x)", "STRING(7", "OCTET_STRING(#x)",
                              "ARRAY [1..27] OF BYTE", "ARRAY [0..27] OF DT1018"})
        CHECK(!esi::bits_of(wrong));
}

TEST_CASE("optional elements are written if present") {
    auto device = test::sample_device<>();
    device.serial = 7;
    device.fmmus = {"Outputs", "Inputs"};
    device.sync_managers.push_back({.use = ethercat::sii_sync_manager_use::outputs,
                                    .start = 0x1800,
                                    .default_size = 2,
                                    .min_size = 1,
                                    .max_size = 4,
                                    .control = 0x64,
                                    .enabled = false});
    device.eeprom.bootstrap.resize(8, std::byte{0x1A});
    const auto text = esi::write_esi(device);
    const auto has = [&](const char* part) { return text.find(part) != text.npos; };
    CHECK(has(R"(<Type ProductCode="#x00000021" RevisionNo="#x00010002" SerialNo="#x00000007">A-1</Type>)"));
    CHECK(has("        </Profile>\n        <Fmmu>Outputs</Fmmu>\n        <Fmmu>Inputs</Fmmu>\n        <Sm "));
    CHECK(has(R"(<Sm MinSize="1" MaxSize="4" DefaultSize="2" StartAddress="#x1800" ControlByte="#x64" Enable="0">)"
              "Outputs</Sm>"));
    CHECK(has("<BootStrap>1A1A1A1A1A1A1A1A</BootStrap>"));
}
