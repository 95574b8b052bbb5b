-- Wireshark dissector of JAUS messages: RA 3.3 and SAE services, over UDP, TCP and EtherCAT.
-- Written by message_tables from the schemas: do not edit it, write it again.
-- dissector.lua is behind the tables.

-- Names of enumerators and bits.
local names = {
{[0]="none",[1]="request",[2]="nak",[3]="ack"},
{[0]="only",[1]="first",[2]="middle",[4]="repeated",[8]="last"},
{[0]="none",[1]="proposed",[2]="answered",[3]="compressed"},
{[0]="low",[1]="standard",[2]="high",[3]="safety_critical"},
{[0]="none",[1]="local",[2]="global"},
{[0]="single",[1]="first",[2]="middle",[3]="last"},
{[0]="transition_to_emergency"},
{[0]="clear_emergency"},
{[0]="connection_created",[1]="node_does_not_support_service_connections",[2]="component_does_not_support_service_connections",[3]="insufficient_authority",[4]="connection_refused",[5]="invalid_service_connection_parameters",[6]="command_not_supported"},
{[0]="control_accepted",[1]="uninterruptible_control_not_supported",[2]="control_not_accepted"},
{[0]="periodic",[1]="every_change",[2]="first_change",[3]="first_change_in_and_out_of_boundary",[4]="periodic_without_repeat",[5]="one_time_on_demand"},
{[0]="equal",[1]="not_equal",[2]="inside_inclusive",[3]="inside_exclusive",[4]="outside_inclusive",[5]="outside_exclusive",[6]="greater_than_or_equal",[7]="strictly_greater_than",[8]="less_than_or_equal",[9]="strictly_less_than"},
{[0]="byte",[1]="short_integer",[2]="integer",[3]="long_integer",[4]="unsigned_short_integer",[5]="unsigned_integer",[6]="unsigned_long_integer",[7]="float",[8]="long_float",[9]="rgb",[255]="none"},
{[0]="successful",[1]="periodic_events_not_supported",[2]="change_based_events_not_supported",[3]="connection_refused",[4]="invalid_event_setup",[5]="message_not_supported",[6]="error_invalid_event_id_for_update_request"},
{[0]="off",[1]="on",[2]="standby",[3]="loss_of_command"},
{[0]="main_propulsion",[1]="main_fuel_supply",[2]="auxiliary_fuel_supply",[3]="power_to_auxiliary_devices",[4]="starting_device",[5]="cold_start",[6]="automatic_start_sequence",[7]="automatic_shutdown_sequence"},
{[0]="parking_brake",[1]="horn"},
{[0]="park",[128]="neutral"},
{[128]="neutral"},
{[0]="aligned_with_the_vehicle_coordinate_system",[1]="aligned_with_the_end_effector_coordinate_system"},
{[0]="linear_x_is_a_rate",[1]="linear_y_is_a_rate",[2]="linear_z_is_a_rate",[3]="angular_x_is_a_rate",[4]="angular_y_is_a_rate",[5]="angular_z_is_a_rate"},
{[0]="auto_focus",[1]="auto_exposure_iris",[2]="image_stabilization",[3]="white_balance",[4]="sync_flash_strobe",[5]="red_eye",[6]="auto_shutter",[7]="video_auto_gain",[8]="interlaced_video"},
{[0]="audio_enabled",[1]="auto_gain",[2]="stereo_audio",[3]="directional_audio",[4]="front_microphone",[5]="rear_microphone",[6]="left_microphone",[7]="right_microphone"},
{[0]="unused",[1]="raw",[2]="pcm",[3]="au",[4]="wav",[5]="mid",[6]="mp3",[7]="mp2",[8]="asf"},
{[0]="unused",[1]="mpeg2",[2]="mpeg4",[3]="mjpeg",[4]="ntsc",[5]="pal",[6]="tiff",[7]="jpeg",[8]="gif",[9]="h263",[10]="h264",[11]="png",[12]="bmp",[13]="raw",[14]="ppm",[15]="pgm",[16]="pnm"},
{[0]="request_confirmation_of_object_creation"},
{[0]="point",[1]="line",[2]="polygon"},
{[0]="append",[1]="prepend",[2]="overwrite",[255]="erase"},
{[0]="replace_the_current_mission",[1]="append_to_the_current_mission"},
{[1]="system_identification",[2]="subsystem_identification",[3]="node_identification",[4]="component_identification"},
{[2]="subsystem_configuration",[3]="node_configuration"},
{[0]="mission",[1]="task",[2]="message"},
{[0]="initialize",[1]="ready",[2]="standby",[3]="shutdown",[4]="failure",[5]="emergency"},
{[1]="revolute",[2]="prismatic"},
{[1]="short_integer",[2]="integer",[3]="long_integer",[4]="byte",[5]="unsigned_short_integer",[6]="unsigned_integer",[7]="unsigned_long_integer",[8]="float",[9]="long_float",[10]="scaled_byte",[11]="scaled_short_integer",[12]="scaled_unsigned_short_integer",[13]="scaled_integer",[14]="scaled_unsigned_integer",[15]="scaled_long_integer",[16]="scaled_unsigned_long_integer",[17]="enumeration",[18]="boolean",[19]="string",[20]="byte_tuple",[21]="unsigned_short_integer_tuple",[22]="unsigned_integer_tuple"},
{[0]="blocking",[1]="non_blocking"},
{[0]="message_count",[1]="distance",[2]="time"},
{[0]="spooling",[1]="pending",[2]="paused",[3]="aborted",[4]="finished"},
{[0]="non_error_condition",[1]="lost_component_control",[2]="tolerance_not_met"},
{[1]="stop"},
{[0]="control_accepted",[1]="not_available",[2]="insufficient_authority"},
{[0]="control_released",[1]="not_available"},
{[0]="periodic_sc",[1]="every_change"},
{[1]="periodic_events_not_supported",[2]="change_based_events_not_supported",[3]="connection_refused",[4]="invalid_event_setup",[5]="message_not_supported",[6]="error_invalid_event_id_for_update_event_request"},
{[0]="jaus_message",[1]="user_defined"},
{[1]="invalid_element_id",[2]="invalid_previous_element",[3]="invalid_next_element",[4]="unsupported_element_type",[5]="element_id_not_found",[6]="out_of_memory",[7]="unspecified_error"},
{[0]="reserved",[1]="operating_zone"},
{[0]="altitude_agl",[1]="altitude_msl",[2]="altitude_asf",[3]="depth"},
{[0]="lat_lon_priority",[1]="z_priority"},
{[0]="vehicle_dependent",[1]="clockwise",[2]="counter_clockwise"},
{[0]="racetrack",[1]="figure8"},
{[0]="altitude_agl",[1]="altitude_msl",[2]="altitude_asf",[3]="depth",[4]="z_local"},
{[0]="xy_priority",[1]="z_priority"},
{[0]="off",[1]="on",[2]="restart"},
{[0]="speed_over_ground",[1]="speed_relative_to_medium",[2]="rotations_per_minute",[3]="indicated_speed"},
{[1]="power_on",[2]="power_off",[3]="power_standby"},
{[1]="glowplug_on",[2]="glowplug_off"},
{[0]="off",[1]="on"},
{[2]="trip_a",[3]="trip_b",[4]="trip_c"},
{[1]="radian",[2]="meter"},
{[1]="radian_per_second",[2]="meter_per_second"},
{[1]="newton_meter",[2]="newton"},
{[0]="unknown_sensor_id",[1]="invalid_horizontal_field_of_view",[2]="invalid_vertical_field_of_view",[3]="invalid_update_rate",[4]="invalid_sensor_range",[5]="invalid_sensor_state",[6]="multiple_invalid_parameters",[255]="unknown_error_fault"},
{[0]="unknown_sensor_id",[1]="invalid_sensor_state",[2]="invalid_zoom_mode",[3]="invalid_zoom_value",[4]="invalid_focus_mode",[5]="invalid_focus_value",[6]="invalid_white_balance",[7]="invalid_imaging_mode",[8]="invalid_exposure_mode",[9]="invalid_metering_mode",[10]="invalid_shutter_speed",[11]="invalid_aperture_value",[12]="invalid_light_sensitivity",[13]="invalid_image_stabilization",[14]="invalid_horizontal_fov",[15]="invalid_vertical_fov",[16]="multiple_invalid_parameters",[255]="unknown_error_fault"},
{[0]="unknown_sensor_id",[1]="invalid_minimum_bit_rate",[2]="invalid_maximum_bit_rate",[3]="requested_frame_rate_too_low",[4]="requested_frame_rate_too_high",[5]="invalid_frame_size",[6]="invalid_format",[7]="multiple_invalid_parameters",[255]="unknown_error_fault"},
{[0]="unknown_sensor_id",[1]="invalid_format",[255]="unknown_error_fault"},
{[0]="unknown_sensor_id",[1]="invalid_frame_size",[2]="invalid_format",[3]="multiple_invalid_parameters",[255]="unknown_error_fault"},
{[0]="unknown_sensor_id",[1]="invalid_profile",[2]="invalid_preset",[3]="invalid_group_of_pictures",[4]="invalid_gdr",[5]="invalid_region_of_interest",[6]="invalid_intra_macro_refresh",[255]="unknown_error_fault"},
{[0]="unknown_sensor_id",[1]="invalid_bit_rate",[2]="invalid_format",[3]="invalid_sample_rate",[4]="invalid_bit_depth",[5]="invalid_encoding_quality",[255]="unknown_error_fault"},
{[0]="unknown_sensor_id",[1]="stream_not_found",[2]="stream_not_supported",[255]="unknown_error_fault"},
{[0]="unknown_sensor_id",[1]="unsupported_mode",[2]="unsupported_beam_width",[3]="unsupported_beam_height",[255]="unknown_error_fault"},
{[0]="active",[1]="standby",[2]="off"},
{[0]="mixed",[1]="analog_only",[2]="digital_only",[3]="off"},
{[0]="auto_focus",[1]="manual_focus"},
{[0]="auto_value",[1]="daylight",[2]="cloudy",[3]="shade",[4]="tungsten",[5]="flurescent",[6]="flash"},
{[0]="color",[1]="greyscale",[2]="infrared",[3]="low_light",[4]="thermal_white_hot",[5]="thermal_black_hot",[6]="thermal_rainbow"},
{[0]="auto_value",[1]="manual",[2]="shutter_priority",[3]="aperture_priority"},
{[0]="auto_value",[1]="center_weighted",[2]="spot"},
{[0]="auto_value",[1]="iso_100",[2]="iso_200",[3]="iso_400",[4]="iso_800",[5]="iso_1600",[6]="iso_3200"},
{[0]="value_128x96_sqcif",[1]="value_176x144_qcif",[2]="value_352x288_cif",[3]="value_704x576_4cif",[4]="value_1408x1152_16cif",[5]="value_160x120_qqvga",[6]="value_320x240_qvga",[7]="value_640x480_vga",[8]="value_800x600_svga",[9]="value_1024x768_xga",[10]="value_1600x1200_uxga",[11]="value_2048x1536_qxga",[12]="value_1280x1024_sxga",[13]="value_2560x2048_qsxga",[14]="value_5120x4096_hsxga",[15]="value_852x480_wvga",[16]="value_1366x768_wxga",[17]="value_1600x1024_wsxga",[18]="value_1920x1200_wuxga",[19]="value_2560x1600_woxga",[20]="value_3200x2048_wqsxga",[21]="value_3840x2400_wquxga",[22]="value_6400x4096_whsxga",[23]="value_7680x4800_whuxga",[24]="value_320x200_cga",[25]="value_640x350_ega",[26]="value_852x480_hd480",[27]="value_1280x720_hd720",[28]="value_1920x1080_hd1080"},
{[0]="avi",[1]="mjpeg",[2]="mpeg_2",[3]="h_263_3",[4]="h_263_4",[5]="mpeg_4_visual_mpeg_4_part_2",[6]="mpeg_4_avc"},
{[0]="play",[1]="pause",[2]="stop"},
{[0]="ntsc_m",[1]="ntsc_j",[2]="pal_n",[3]="pal_m",[4]="secam_l",[5]="secam_b_g"},
{[0]="jpeg",[1]="gif",[2]="png",[3]="bmp",[4]="tiff",[5]="ppm",[6]="pgm",[7]="pnm",[8]="nef",[9]="cr2",[10]="dng"},
{[0]="rtsp",[1]="mpeg2_ts",[2]="ftp",[3]="sftp",[4]="ftp_over_ssh",[5]="http",[6]="https",[7]="scp",[8]="ccsi"},
{[0]="not_recording",[1]="recording"},
{[0]="play_once",[1]="repeat_until_new_stream_specified"},
{[0]="visible",[1]="infrared",[2]="greyscale",[3]="lowlight"},
{[0]="all_zones",[1]="operating_zone"},
{[1]="platform",[2]="trip_a",[3]="trip_b",[4]="trip_c"},
{[0]="all_sensors"},
{[0]="native_coordinate_system",[1]="vehicle_coordinate_system"},
{[0]="none",[1]="deflate",[2]="bzip2",[3]="lzma"},
{[0]="native_coordinate_systems",[1]="vehicle_coordinate_systems"},
{[0]="reserved",[1]="system_identification",[2]="subsystem_identification",[3]="node_identification",[4]="component_identification"},
{[0]="reserved_0",[1]="reserved_1",[2]="subsystem_identification",[3]="node_identification"},
{[0]="reserved",[255]="all_nodes_in_the_subsystem"},
{[0]="reserved",[255]="all_components_in_the_subsystem"},
{[0]="reserved"},
{[0]="timeout_feature_disabled"},
{[0]="successful",[1]="unsuccessful"},
{[0]="inside_safe_op_zone",[1]="outsize_safe_op_zone",[2]="inside_safe_op_zone_and_inside_exclusion_zone"},
{[0]="invalid",[1]="valid"},
{[0]="optimal_gps_signal",[1]="good_gps_signal",[2]="minimal_gps_signal",[3]="no_gps_signal"},
{[0]="stable_gps_fix",[1]="initiating_gps_fix",[2]="performing_gps_fix"},
{[0]="false_value",[1]="true_value"},
{[0]="off",[1]="on",[2]="restarting"},
{[0]="init",[1]="operational",[2]="coarse_stationary_alignment",[3]="coarse_gps_alignment",[4]="fine_stationary_alignment_started",[5]="fine_stationary_alignment_complete",[6]="fine_gps_alignment_started",[7]="fine_gps_alignment_complete",[8]="inertial_sensor_failure"},
{[0]="not_supported",[1]="supported"},
{[0]="unsupported",[1]="supported"},
{[0]="sensor_is_not_active",[1]="invalid_compression_format",[255]="unknown_error_failure"},
}
-- Forms of values.
local forms = {
{"integer",bits=4},
{"integer",bits=2,names=1},
{"integer",bits=1,boolean=true},
{"integer",bits=6},
{"integer",bits=2},
{"integer",bits=16},
{"integer",bits=8},
{"structure",2},
{"integer",bits=12},
{"integer",bits=4,names=2},
{"integer",bits=2,names=3},
{"integer",bits=2,names=4},
{"integer",bits=2,names=5},
{"integer",bits=2,names=6},
{"structure",4},
{"integer",bits=16,flags=7},
{"integer",bits=16,flags=8},
{"scaled",bits=16,min=0,max=1092,unit="Hz"},
{"integer",bits=32},
{"integer",bits=8,names=9},
{"integer",bits=2,names=10},
{"integer",bits=10},
{"integer",bits=5},
{"packed",22,bits=32},
{"integer",bits=7},
{"packed",23,bits=16},
{"integer",bits=8,names=11},
{"integer",bits=8,names=12},
{"integer",bits=8,names=13},
{"integer",bits=16,signed=true},
{"integer",bits=32,signed=true},
{"integer",bits=64,signed=true},
{"integer",bits=64},
{"real",bits=32},
{"real",bits=64},
{"structure",26},
{"choice",{[0]=7,[1]=30,[2]=31,[3]=32,[4]=6,[5]=19,[6]=33,[7]=34,[8]=35,[9]=36,[255]=0,}},
{"structure",25},
{"octets"},
{"integer",bits=8,names=14},
{"octets",text=true,rest=true},
{"integer",bits=8,names=15},
{"scaled",bits=32,min=-65.534000000000006,max=65.534000000000006,signed=true,unit="m/s"},
{"scaled",bits=32,min=0,max=100,unit="m/s"},
{"scaled",bits=16,min=-32.767000000000003,max=32.767000000000003,signed=true,unit="rad/s"},
{"scaled",bits=16,min=0,max=3.1415926535897931,unit="rad/s"},
{"scaled",bits=16,min=-100,max=100,signed=true,unit="%"},
{"scaled",bits=8,min=0,max=100,unit="%"},
{"integer",bits=8,flags=16},
{"integer",bits=8,flags=17},
{"integer",bits=8,names=18},
{"integer",bits=8,names=19},
{"scaled",bits=16,min=0,max=10000,unit="m/s"},
{"scaled",bits=32,min=-10000,max=35000,signed=true,unit="m"},
{"scaled",bits=16,min=-3.1415926535897931,max=3.1415926535897931,signed=true,unit="rad"},
{"scaled",bits=32,min=0,max=10000,signed=true,unit="m/s"},
{"scaled",bits=32,min=-90,max=90,signed=true,unit="deg"},
{"scaled",bits=32,min=-180,max=180,signed=true,unit="deg"},
{"scaled",bits=32,min=-100000,max=100000,signed=true,unit="m"},
{"scaled",bits=16,min=0,max=500},
{"scaled",bits=16,min=-100,max=100,unit="%"},
{"list",61,field="joint_effort"},
{"scaled",bits=32,min=-25.132741228718345,max=25.132741228718345,unit="rad"},
{"list",63,field="joint_position"},
{"scaled",bits=32,min=-31.415926535897931,max=31.415926535897931,unit="rad/s"},
{"list",65,field="joint_velocity"},
{"scaled",bits=32,min=-15,max=15,unit="m"},
{"scaled",bits=32,min=-30,max=30,unit="m"},
{"scaled",bits=32,min=-1,max=1},
{"integer",bits=8,names=20},
{"scaled",bits=32,min=-62.831853071795862,max=62.831853071795862,unit="rad/s"},
{"scaled",bits=32,min=-10,max=10,unit="m/s"},
{"scaled",bits=32,min=0,max=6000,unit="s"},
{"scaled",bits=32,min=-31.415926535897931,max=31.415926535897931,unit="rad/s^2"},
{"structure",52},
{"list",75},
{"structure",51},
{"list",77},
{"structure",54},
{"list",79},
{"integer",bits=8,flags=21},
{"scaled",bits=16,min=0,max=3.1415926535897931,unit="rad"},
{"integer",bits=16,unit="px"},
{"integer",bits=16,unit="1/s"},
{"integer",bits=16,unit="s"},
{"integer",bits=16,flags=22},
{"integer",bits=16,flags=23},
{"integer",bits=8,names=24},
{"integer",bits=8,names=25},
{"integer",bits=8,flags=26},
{"integer",bits=8,names=27},
{"real",bits=32,unit="m"},
{"structure",61},
{"list",93},
{"structure",62},
{"list",95},
{"structure",60},
{"list",97},
{"integer",bits=8,names=28},
{"octets",text=true},
{"list",19,field="object_id"},
{"structure",66},
{"list",102},
{"octets",rest=true},
{"integer",bits=8,names=29},
{"list",19,field="offset"},
{"structure",1},
{"message",71},
{"structure",70},
{"list",109,field="mission_message"},
{"structure",69},
{"tree",111,depth=16,children="number_of_children"},
{"list",6,field="message_uid"},
{"structure",118},
{"list",114},
{"integer",bits=8,names=30},
{"integer",bits=8,names=31},
{"list",7,field="information_interface_number"},
{"integer",bits=8,names=32},
{"integer",bits=8,names=33},
{"structure",132},
{"list",121},
{"octets",text=true,size=15,filled=true},
{"scaled",bits=16,min=0,max=32.767000000000003,unit="m"},
{"scaled",bits=16,min=0,max=65.534999999999997,unit="m"},
{"scaled",bits=16,min=0,max=2.5600000000000001,unit="rad"},
{"scaled",bits=16,min=0,max=65.534999999999997,unit="m/s"},
{"scaled",bits=16,min=0,max=32.767000000000003,unit="rad/s"},
{"scaled",bits=16,min=-75,max=180,signed=true,unit="deg C"},
{"integer",bits=32,unit="m"},
{"scaled",bits=8,min=0,max=127,unit="%"},
{"scaled",bits=32,min=0,max=100,unit="m"},
{"integer",bits=8,names=34},
{"integer",bits=16,unit="mm"},
{"integer",bits=16,unit="mrad"},
{"structure",154},
{"list",136},
{"scaled",bits=32,min=-1000,max=1000,unit="N m"},
{"list",138,field="joint_force_torque"},
{"scaled",bits=16,min=-32.767000000000003,max=32.767000000000003,signed=true,unit="m"},
{"scaled",bits=16,min=-1,max=1,signed=true},
{"scaled",bits=32,min=-10000,max=10000,signed=true,unit="m"},
{"scaled",bits=32,min=0,max=1000,unit="m"},
{"scaled",bits=32,min=-3.1415926535897931,max=3.1415926535897931,signed=true,unit="rad"},
{"scaled",bits=32,min=0,max=3.1415926535897931,unit="rad"},
{"octets",text=true,size=50,filled=true},
{"structure",171},
{"list",147},
{"octets",text=true,rest=true,filled=true},
{"structure",176},
{"list",150},
{"structure",175},
{"list",152},
{"structure",178},
{"list",154},
{"structure",181},
{"list",156},
{"structure",180},
{"list",158},
{"octets",text=true,terminated=true},
{"integer",bits=8,names=35},
{"integer",bits=8,names=36},
{"structure",184},
{"structure",185},
{"structure",186},
{"choice",{[1]=30,[2]=31,[3]=32,[4]=7,[5]=6,[6]=19,[7]=33,[8]=34,[9]=35,[10]=34,[11]=34,[12]=34,[13]=34,[14]=34,[15]=34,[16]=34,[17]=7,[18]=7,[19]=7,[20]=163,[21]=164,[22]=165,}},
{"structure",183},
{"list",167},
{"structure",187},
{"list",169},
{"integer",bits=8,names=37},
{"integer",bits=8,names=38},
{"integer",bits=8,names=39},
{"integer",bits=16,names=40,values={{1,1}}},
{"integer",bits=8,names=41,values={{0,2}}},
{"integer",bits=8,names=42,values={{0,1}}},
{"integer",bits=8,names=43,values={{0,1}}},
{"scaled",bits=16,min=0,max=1092,unit="hertz"},
{"integer",bits=32,values={{2,2147483647}}},
{"message"},
{"integer",bits=8,names=44,values={{1,6}}},
{"octets",text=true,size=80,filled=true},
{"integer",bits=32,unit="second"},
{"scaled",bits=32,min=-90,max=90,unit="degree"},
{"scaled",bits=32,min=-180,max=180,unit="degree"},
{"scaled",bits=32,min=-10000,max=35000,unit="meter"},
{"scaled",bits=32,min=0,max=100,unit="meter"},
{"scaled",bits=16,min=-3.1415926535897931,max=3.1415926535897931,unit="radian"},
{"scaled",bits=16,min=0,max=3.1415926535897931,unit="radian"},
{"integer",bits=10,values={{0,999}}},
{"integer",bits=6,values={{0,59}}},
{"integer",bits=5,values={{0,23}}},
{"integer",bits=5,values={{1,31}}},
{"packed",209,bits=32},
{"scaled",bits=16,min=-100,max=100,unit="percent"},
{"scaled",bits=8,min=0,max=100,unit="percent"},
{"scaled",bits=16,min=0,max=327.67000000000002,unit="meter per second"},
{"scaled",bits=16,min=0,max=100,unit="meter"},
{"scaled",bits=32,min=0,max=100000,unit="meter"},
{"scaled",bits=32,min=-100000,max=100000,unit="meter"},
{"structure",218},
{"integer",bits=8,names=45,values={{0,1}}},
{"structure",220},
{"structure",219},
{"list",204},
{"structure",222},
{"list",206},
{"integer",bits=8,names=46,values={{1,7}}},
{"integer",bits=16,names=47},
{"structure",227},
{"list",210},
{"integer",bits=8,names=48},
{"scaled",bits=32,min=-50000,max=50000,unit="meter"},
{"choice",{[0]=213,[1]=213,[2]=213,[3]=213,}},
{"structure",230},
{"structure",231},
{"structure",229},
{"list",217},
{"structure",234},
{"structure",233},
{"list",220},
{"structure",232},
{"list",222},
{"structure",237},
{"structure",236},
{"integer",bits=8,names=49,values={{0,1}}},
{"scaled",bits=32,min=0,max=50000,unit="meter"},
{"structure",238},
{"integer",bits=8,names=50,values={{0,2}}},
{"structure",239},
{"integer",bits=8,names=51,values={{0,1}}},
{"scaled",bits=32,min=0,max=200000,unit="meter"},
{"structure",240},
{"variant",{{"global_loiter_driver_hover_rec",228},{"polygon_rec",230},{"race_track_rec",233},},bits=8},
{"scaled",bits=32,min=-20000000,max=20000000,unit="meter"},
{"integer",bits=8,names=52},
{"choice",{[0]=213,[1]=213,[2]=213,[3]=213,[4]=213,}},
{"structure",243},
{"structure",242},
{"integer",bits=8,names=53,values={{0,1}}},
{"structure",244},
{"variant",{{"local_loiter_driver_hover_rec",241},{"polygon_rec",230},{"race_track_rec",233},},bits=8},
{"structure",247},
{"structure",248},
{"structure",246},
{"list",245},
{"structure",251},
{"structure",250},
{"list",248},
{"structure",249},
{"list",250},
{"integer",bits=8,names=54,values={{0,2}}},
{"structure",255},
{"integer",bits=8,names=55},
{"scaled",bits=16,min=-327.68000000000001,max=327.67000000000002,unit="meter per second"},
{"scaled",bits=16,min=-1000,max=1000,unit="rotations per minute"},
{"choice",{[0]=255,[1]=255,[2]=256,[3]=255,}},
{"structure",257},
{"structure",258},
{"structure",260},
{"structure",263},
{"scaled",bits=32,min=0,max=10000,unit="meter"},
{"structure",265},
{"scaled",bits=16,min=-1.5707963267948966,max=1.5707963267948966,unit="radian"},
{"scaled",bits=16,min=0,max=100},
{"scaled",bits=16,min=0,max=32.767000000000003,unit="radian per second"},
{"scaled",bits=16,min=0,max=500,unit="newton meter"},
{"scaled",bits=16,min=-100,max=100},
{"structure",270},
{"list",269},
{"scaled",bits=16,min=-3.1415899999999999,max=3.1415899999999999,unit="radian"},
{"structure",272},
{"list",272},
{"structure",275},
{"integer",bits=8,names=56,values={{1,3}}},
{"structure",276},
{"integer",bits=8,names=57,values={{1,2}}},
{"structure",277},
{"structure",278},
{"structure",279},
{"structure",280},
{"variant",{{"gas_engine_configuration_rec",276},{"diesel_engine_configuration_rec",278},{"battery_configuration_rec",279},{"hydraulic_configuration_rec",280},{"fuel_cell_configuration_recs",281},},bits=8},
{"structure",274},
{"list",283},
{"scaled",bits=8,min=0,max=100},
{"integer",bits=1,names=58},
{"packed",283,bits=32},
{"integer",bits=8,names=59,values={{2,4}}},
{"structure",286},
{"list",289},
{"integer",bits=8,names=60},
{"scaled",bits=32,min=-25.132741228718345,max=25.132741228718345,unit="radian"},
{"scaled",bits=32,min=-10,max=10,unit="meter"},
{"choice",{[1]=292,[2]=293,}},
{"structure",289},
{"structure",288},
{"list",296},
{"integer",bits=8,names=61},
{"scaled",bits=32,min=-31.415926535897931,max=31.415926535897931,unit="radian per second"},
{"scaled",bits=32,min=-5,max=5,unit="meter per second"},
{"choice",{[1]=299,[2]=300,}},
{"structure",292},
{"structure",291},
{"list",303},
{"scaled",bits=32,min=-30,max=30,unit="meter"},
{"scaled",bits=32,min=-62.831853071795862,max=62.831853071795862,unit="radian per second"},
{"scaled",bits=32,min=-10,max=10,unit="meter per second"},
{"integer",bits=8,names=62},
{"scaled",bits=32,min=-1000,max=1000,unit="newton meter"},
{"scaled",bits=32,min=-500,max=500,unit="newton"},
{"choice",{[1]=309,[2]=310,}},
{"structure",297},
{"structure",296},
{"list",313},
{"scaled",bits=32,min=0,max=31.415926535897931,unit="radian per second"},
{"scaled",bits=32,min=0,max=31.415926535897931,unit="radian per second squared"},
{"structure",303},
{"integer",bits=16,values={{1,65535}}},
{"structure",305},
{"integer",bits=8,names=63,values={{0,6},{255,255}}},
{"structure",306},
{"integer",bits=8,names=64,values={{0,16},{255,255}}},
{"structure",307},
{"integer",bits=8,names=65,values={{0,7},{255,255}}},
{"structure",308},
{"integer",bits=8,names=66,values={{0,1},{255,255}}},
{"structure",309},
{"integer",bits=8,names=67,values={{0,3},{255,255}}},
{"structure",310},
{"integer",bits=8,names=68,values={{0,6},{255,255}}},
{"structure",311},
{"integer",bits=8,names=69,values={{0,5},{255,255}}},
{"structure",312},
{"integer",bits=8,names=70,values={{0,2},{255,255}}},
{"structure",313},
{"integer",bits=8,names=71,values={{0,3},{255,255}}},
{"structure",314},
{"variant",{{"shared_sensor_id_rec",319},{"range_sensor_error_rec",321},{"visual_sensor_error_rec",323},{"digital_video_sensor_error_rec",325},{"analog_video_sensor_error_rec",327},{"still_image_sensor_error_rec",329},{"h264_video_encoding_error_rec",331},{"digital_audio_sensor_error_rec",333},{"digital_audio_output_error_rec",335},{"video_illuminator_error_rec",337},},bits=8},
{"structure",304},
{"list",339},
{"structure",316},
{"scaled",bits=32,min=-3.1415926535897931,max=3.1415926535897931,unit="radian"},
{"scaled",bits=16,min=0,max=1000,unit="hertz"},
{"scaled",bits=32,min=0,max=1000000,unit="meter"},
{"integer",bits=8,names=72,values={{0,2}}},
{"structure",317},
{"list",346},
{"structure",319},
{"integer",bits=8,names=73,values={{0,3}}},
{"scaled",bits=16,min=0,max=100,unit="percent"},
{"scaled",bits=32,min=0,max=2,unit="meter"},
{"integer",bits=8,names=74,values={{0,1}}},
{"integer",bits=8,names=75,values={{0,6}}},
{"integer",bits=8,names=76,values={{0,31}}},
{"integer",bits=8,names=77,values={{0,3}}},
{"integer",bits=8,names=78,values={{0,2}}},
{"scaled",bits=16,min=0,max=60,unit="second"},
{"scaled",bits=16,min=0.10000000000000001,max=128},
{"integer",bits=8,names=79,values={{0,6}}},
{"integer",bits=8,names=58,values={{0,1}}},
{"structure",320},
{"list",361},
{"structure",322},
{"integer",bits=8,names=80,values={{0,28}}},
{"integer",bits=8,names=81,values={{0,6}}},
{"structure",323},
{"list",366},
{"integer",bits=8,names=82,values={{0,2}}},
{"structure",326},
{"integer",bits=8,names=83,values={{0,5}}},
{"structure",327},
{"list",371},
{"structure",329},
{"integer",bits=8,names=84,values={{0,10}}},
{"structure",330},
{"list",375},
{"structure",332},
{"integer",bits=8,names=85},
{"packed",334,bits=32},
{"structure",333},
{"integer",bits=8,names=86,values={{0,1}}},
{"structure",339},
{"integer",bits=8,names=87,values={{0,1}}},
{"structure",340},
{"list",384},
{"structure",342},
{"integer",bits=8,names=88,values={{0,31}}},
{"scaled",bits=16,min=0,max=360,unit="degree"},
{"structure",343},
{"list",389},
{"structure",345},
{"list",391},
{"structure",351},
{"structure",352},
{"structure",353},
{"integer",bits=8,values={{0,0}}},
{"structure",354},
{"variant",{{"message_id_rec",393},{"event_type_rec",394},{"event_id_rec",395},{"all_events_rec",397},},bits=8},
{"integer",bits=16,names=89},
{"structure",394},
{"list",400},
{"list",274},
{"integer",bits=8,names=90,values={{1,4}}},
{"integer",bits=16,names=91},
{"structure",423},
{"list",405},
{"structure",425},
{"list",407},
{"integer",bits=8,names=92,values={{0,1}}},
{"structure",427},
{"list",410},
{"integer",bits=8,names=93,values={{0,3}}},
{"structure",429},
{"list",413},
{"structure",431},
{"list",415},
{"structure",433},
{"list",417},
{"structure",435},
{"list",419},
{"structure",437},
{"list",421},
{"structure",439},
{"list",423},
{"structure",441},
{"list",425},
{"integer",bits=8,names=94,values={{0,1}}},
{"structure",443},
{"list",428},
{"structure",447},
{"list",430},
{"structure",449},
{"list",432},
{"structure",454},
{"list",434},
{"structure",457},
{"list",436},
{"structure",459},
{"list",438},
{"integer",bits=8,names=95},
{"integer",bits=8,names=96},
{"integer",bits=8,values={{1,255}}},
{"integer",bits=8,names=97},
{"structure",466},
{"integer",bits=8,names=98},
{"structure",467},
{"list",446},
{"structure",465},
{"list",448},
{"integer",bits=16,names=99},
{"structure",470},
{"structure",472},
{"structure",473},
{"list",453},
{"structure",471},
{"list",455},
{"structure",469},
{"list",457},
{"integer",bits=8,names=33,values={{0,5}}},
{"integer",bits=8,names=100},
{"structure",479},
{"list",461},
{"integer",bits=8,names=101,values={{0,1}}},
{"scaled",bits=32,min=-327.68000000000001,max=327.67000000000002,unit="meter per second"},
{"scaled",bits=32,min=0,max=100,unit="meter per second"},
{"scaled",bits=16,min=-32.768000000000001,max=32.767000000000003,unit="radian per second"},
{"scaled",bits=16,min=0,max=3.1415926535897931,unit="radian per second"},
{"scaled",bits=32,min=-1310.6800000000001,max=1310.6800000000001,unit="meter per second squared"},
{"scaled",bits=32,min=0,max=100,unit="meter per second squared"},
{"scaled",bits=32,min=-13106.799999999999,max=13106.799999999999,unit="radian per second squared"},
{"scaled",bits=16,min=0,max=3.1415926535897931,unit="radian per second squared"},
{"structure",498},
{"list",472},
{"integer",bits=8,names=102,values={{0,2}}},
{"structure",503},
{"list",475},
{"structure",508},
{"integer",bits=8,names=103,values={{0,1}}},
{"structure",509},
{"integer",bits=8,names=104,values={{0,3}}},
{"integer",bits=8,names=105,values={{0,2}}},
{"integer",bits=8,names=106,values={{0,1}}},
{"structure",510},
{"variant",{{"min_gps_rec",479},{"alt_gps_rec",483},},bits=8},
{"integer",bits=8,names=107,values={{0,2}}},
{"integer",bits=8,names=108,values={{0,8}}},
{"structure",514},
{"structure",515},
{"structure",516},
{"variant",{{"velocity_vehicle_xyz_rec",487},{"velocity_local_xyz_rec",488},{"velocity_ned_rec",489},},bits=8},
{"scaled",bits=32,min=-32.768000000000001,max=32.767000000000003,unit="radian per second"},
{"scaled",bits=16,min=0,max=100,unit="radian per second"},
{"structure",517},
{"structure",522},
{"structure",525},
{"structure",526},
{"structure",528},
{"structure",529},
{"scaled",bits=16,min=0,max=1000,unit="radian per second squared"},
{"scaled",bits=16,min=-32.767000000000003,max=32.768000000000001,unit="radian per second"},
{"scaled",bits=16,min=-500,max=500,unit="newton meter"},
{"scaled",bits=16,min=0,max=30,unit="meter"},
{"scaled",bits=16,min=0,max=10,unit="meter"},
{"structure",534},
{"scaled",bits=16,min=0,max=25,unit="meter"},
{"structure",535},
{"variant",{{"skidsteer",504},{"ackermann",506},},bits=8},
{"scaled",bits=16,min=0,max=90,unit="meter per second"},
{"scaled",bits=16,min=0,max=6.2800000000000002,unit="radian per second"},
{"scaled",bits=8,min=0,max=40,unit="meter per second squared"},
{"structure",536},
{"scaled",bits=16,min=-30,max=30,unit="meter"},
{"scaled",bits=16,min=0,max=60,unit="meter"},
{"scaled",bits=32,min=0,max=1000000,unit="kilogram"},
{"scaled",bits=16,min=0,max=1.5707963267948966,unit="radian"},
{"structure",537},
{"structure",540},
{"list",517},
{"scaled",bits=16,min=0,max=3.1415899999999999,unit="radian"},
{"scaled",bits=16,min=-3.1415799999999998,max=0,unit="radian"},
{"structure",543},
{"scaled",bits=16,min=-32.768000000000001,max=32.767000000000003,unit="meter"},
{"structure",544},
{"list",523},
{"structure",542},
{"list",525},
{"structure",548},
{"scaled",bits=16,min=0,max=256,unit="liter"},
{"scaled",bits=16,min=0,max=512,unit="bar"},
{"scaled",bits=16,min=-75,max=180,unit="degree Celsius"},
{"scaled",bits=16,min=0,max=256,unit="degree Celsius"},
{"structure",549},
{"scaled",bits=16,min=0,max=256,unit="second"},
{"structure",550},
{"scaled",bits=16,min=0,max=1000,unit="volt"},
{"scaled",bits=32,min=0,max=3600000,unit="coulomb"},
{"scaled",bits=16,min=0,max=5000,unit="ampere"},
{"structure",552},
{"list",538},
{"structure",551},
{"structure",553},
{"scaled",bits=16,min=0,max=256,unit="kilogram"},
{"structure",554},
{"variant",{{"gas_engine_capabilities_rec",532},{"diesel_engine_capabilities_rec",534},{"battery_capabilities_list",540},{"hydraulic_capabilities_rec",541},{"fuel_cell_capabilities_rec",543},},bits=8},
{"structure",547},
{"list",545},
{"scaled",bits=16,min=0,max=200},
{"integer",bits=32,unit="hour"},
{"structure",557},
{"scaled",bits=8,min=0,max=200},
{"structure",558},
{"scaled",bits=16,min=0,max=1000,unit="ampere"},
{"structure",560},
{"list",553},
{"structure",559},
{"structure",561},
{"structure",562},
{"variant",{{"gas_engine_status",549},{"diesel_engine_status",551},{"battery_status",555},{"hydraulic_status",556},{"fuel_cell_status",557},},bits=8},
{"structure",556},
{"list",559},
{"integer",bits=1,names=109},
{"packed",566,bits=32},
{"integer",bits=32,unit="meter"},
{"structure",569},
{"scaled",bits=16,min=-10,max=10,unit="meter"},
{"scaled",bits=32,min=0,max=5000,unit="newton meter"},
{"structure",570},
{"scaled",bits=32,min=0,max=5000,unit="newton"},
{"structure",571},
{"variant",{{"revolute_joint1_offset_rec",567},{"prismatic_joint1_angle_rec",569},},bits=8},
{"structure",573},
{"structure",574},
{"variant",{{"revolute_joint_specification_rec",571},{"prismatic_joint_specification_rec",572},},bits=8},
{"structure",572},
{"list",574},
{"structure",575},
{"list",576},
{"integer",bits=1,names=110},
{"packed",595,bits=8},
{"packed",596,bits=8},
{"structure",594},
{"list",581},
{"integer",bits=8,names=111,values={{0,1},{255,255}}},
{"structure",600},
{"packed",603,bits=32},
{"structure",602},
{"scaled",bits=32,min=0,max=3.1415926535897931,unit="radian"},
{"structure",604},
{"list",588},
{"structure",601},
{"variant",{{"range_sensor_data_error_rec",584},{"range_sensor_data_seq",590},},bits=8},
{"structure",599},
{"list",592},
{"integer",bits=32,values={{0,2147483647}}},
{"structure",607},
{"variant",{{"range_sensor_data_error_rec",584},{"range_sensor_compressed_data_rec",595},},bits=8},
{"structure",606},
{"list",597},
{"structure",610},
{"list",305,count=3},
{"list",69,count=4},
{"structure",611},
{"structure",612},
{"variant",{{"no_geometric_properties_variant",599},{"static_geometric_properties_rec",602},{"manipulator_geometric_properties_rec",603},},bits=8},
{"structure",609},
{"list",605},
{"packed",615,bits=8},
{"packed",616,bits=8},
{"packed",617,bits=8},
{"integer",bits=1,names=99,values={{0,0}}},
{"packed",618,bits=8},
{"packed",619,bits=8},
{"packed",620,bits=8},
{"packed",621,bits=8},
{"structure",614},
{"list",615},
{"packed",626,bits=8},
{"integer",bits=14,names=99,values={{0,0}}},
{"integer",bits=11,names=99,values={{0,0}}},
{"packed",627,bits=32},
{"structure",625},
{"list",621},
{"scaled",bits=16,min=-5000,max=5000,unit="newton"},
{"scaled",bits=16,min=-5000,max=5000,unit="newton meter"},
{"structure",629},
{"list",625},
{"structure",631},
{"list",627},
{"packed",634,bits=8},
{"structure",633},
{"list",630},
{"packed",638,bits=32},
{"packed",639,bits=16},
{"structure",637},
{"list",634},
{"list",380},
{"packed",645,bits=32},
{"packed",646,bits=16},
{"structure",644},
{"list",639},
{"integer",bits=17,values={{0,1}}},
{"integer",bits=11,values={{0,1}}},
{"packed",651,bits=32},
{"integer",bits=16,unit="lumen"},
{"structure",650},
{"structure",652},
{"list",646},
{"structure",649},
{"list",648},
{"structure",655},
{"structure",654},
{"list",651},
{"packed",658,bits=8},
{"integer",bits=8,names=110,values={{0,1}}},
{"structure",657},
{"list",655},
{"structure",660},
{"list",657},
{"integer",bits=16,names=99,values={{10001,65535},{0,0}}},
{"structure",664},
{"structure",665},
{"list",661},
{"structure",663},
{"list",663},
{"structure",667},
{"list",665},
{"structure",670},
{"structure",672},
{"structure",671},
{"list",669},
{"structure",669},
{"list",671},
{"structure",675},
{"structure",677},
{"structure",676},
{"list",675},
{"structure",674},
{"list",677},
}
-- Structures: name, members in wire order.
local structures = {
[2]={"address",{"instance",7},{"component",7},{"node",7},{"subsystem",7}},
[1]={"header",{"priority",1,first=0,carrier=16},{"ack_nak",2,first=4,carrier=16},{"service_connection",3,first=6,carrier=16},{"experimental",3,first=7,carrier=16},{"version",4,first=8,carrier=16},{"reserved",5,first=14,carrier=16,ends=true},{"command_code",6},{"destination",8},{"source",8},{"data_size",9,first=0,carrier=16},{"data_flag",10,first=12,carrier=16,ends=true},{"sequence_number",6}},
[4]={"jaus_id",{"component",7},{"node",7},{"subsystem",6}},
[3]={"transport_header",{"message_type",4,first=0,carrier=8},{"compression",11,first=6,carrier=8,ends=true},{"size",6},{"priority",12,first=0,carrier=8},{"broadcast",13,first=2,carrier=8},{"acknowledgement",2,first=4,carrier=8},{"fragment_flag",14,first=6,carrier=8,ends=true},{"destination",15},{"source",15}},
[5]={"set_component_authority",{"authority_code",7}},
[6]={"shutdown"},
[7]={"standby"},
[8]={"resume"},
[9]={"reset"},
[10]={"set_emergency",{"emergency_code",16}},
[11]={"clear_emergency",{"emergency_code",17}},
[12]={"create_service_connection",{"command_code",6},{"requested_periodic_update_rate",18},{"requested_presence_vector",19}},
[13]={"confirm_service_connection",{"command_code",6},{"instance_id",7},{"confirmed_periodic_update_rate",18},{"response_code",20}},
[14]={"activate_service_connection",{"command_code",6},{"instance_id",7}},
[15]={"suspend_service_connection",{"command_code",6},{"instance_id",7}},
[16]={"terminate_service_connection",{"command_code",6},{"instance_id",7}},
[17]={"request_component_control",{"authority_code",7}},
[18]={"release_component_control"},
[19]={"confirm_component_control",{"response_code",21,first=0,carrier=8,ends=true}},
[20]={"reject_component_control"},
[22]={"time_stamp",{"milliseconds",22,first=0,carrier=32},{"seconds",4,first=10,carrier=32},{"minutes",4,first=16,carrier=32},{"hours",23,first=22,carrier=32},{"day",23,first=27,carrier=32,ends=true}},
[23]={"date_stamp",{"day",23,first=0,carrier=16},{"month",1,first=5,carrier=16},{"year",25,first=9,carrier=16,ends=true}},
[21]={"set_time",{"presence_vector",7,vector=2},{"time_stamp",24,bit=0},{"date_stamp",26,bit=1}},
[26]={"rgb",{"red",7},{"green",7},{"blue",7}},
[25]={"typed_value",{"data_type",29},{"value",37,tag={25,"data_type"}}},
[24]={"create_event",{"presence_vector",7,vector=8},{"local_request_id",7},{"message_code",6},{"event_type",27},{"event_boundary",28,bit=0},{"limit_data_field",7,bit=1},{"lower_limit",38,bit=2},{"upper_limit",38,bit=3},{"state_limit",38,bit=4},{"requested_minimum_periodic_rate",18,bit=5},{"requested_periodic_rate",18,bit=6},{"query_message_size",19,counts=true,bit=7},{"query_message_body",39,bit=7}},
[27]={"update_event",{"presence_vector",7,vector=8},{"local_request_id",7},{"message_code",6},{"event_type",27},{"event_boundary",28,bit=0},{"limit_data_field",7,bit=1},{"lower_limit",38,bit=2},{"upper_limit",38,bit=3},{"state_limit",38,bit=4},{"requested_minimum_periodic_rate",18,bit=5},{"requested_periodic_rate",18,bit=6},{"event_id",7},{"query_message_size",19,counts=true,bit=7},{"query_message_body",39,bit=7}},
[28]={"cancel_event",{"presence_vector",7,vector=2},{"local_request_id",7},{"message_code",6,bit=0},{"event_id",7,bit=1}},
[29]={"confirm_event_request",{"presence_vector",7,vector=1},{"local_request_id",7},{"message_code",6},{"event_id",7},{"confirmed_periodic_rate",18,bit=0},{"response_code",40}},
[30]={"reject_event_request",{"presence_vector",7,vector=1},{"local_request_id",7},{"response_code",40},{"error_message",41,bit=0}},
[31]={"set_data_link_state",{"state",42}},
[32]={"set_data_link_select",{"data_link_id",7}},
[33]={"set_selected_data_link_state",{"data_link_id",7},{"state",42}},
[34]={"set_velocity_state",{"presence_vector",6,vector=9},{"velocity_x",43,bit=0},{"velocity_y",43,bit=1},{"velocity_z",43,bit=2},{"velocity_rms",44,bit=3},{"roll_rate",45,bit=4},{"pitch_rate",45,bit=5},{"yaw_rate",45,bit=6},{"rate_rms",46,bit=7},{"time_stamp",24,bit=8}},
[35]={"set_wrench_effort",{"presence_vector",6,vector=12},{"propulsive_linear_effort_x",47,bit=0},{"propulsive_linear_effort_y",47,bit=1},{"propulsive_linear_effort_z",47,bit=2},{"propulsive_rotational_effort_x",47,bit=3},{"propulsive_rotational_effort_y",47,bit=4},{"propulsive_rotational_effort_z",47,bit=5},{"resistive_linear_effort_x",48,bit=6},{"resistive_linear_effort_y",48,bit=7},{"resistive_linear_effort_z",48,bit=8},{"resistive_rotational_effort_x",48,bit=9},{"resistive_rotational_effort_y",48,bit=10},{"resistive_rotational_effort_z",48,bit=11}},
[36]={"set_discrete_devices",{"presence_vector",7,vector=4},{"main_propulsion",49,bit=0},{"parking_brake_and_horn",50,bit=1},{"gear",51,bit=2},{"transfer_case",52,bit=3}},
[37]={"set_global_vector",{"presence_vector",7,vector=5},{"desired_speed",53,bit=0},{"desired_elevation",54,bit=1},{"desired_heading",55,bit=2},{"desired_roll",55,bit=3},{"desired_pitch",55,bit=4}},
[38]={"set_local_vector",{"desired_speed",56},{"desired_heading",55}},
[39]={"set_travel_speed",{"desired_speed",53}},
[40]={"set_global_waypoint",{"presence_vector",7,vector=4},{"waypoint_number",6},{"latitude",57},{"longitude",58},{"altitude",54,bit=0},{"desired_roll",55,bit=1},{"desired_pitch",55,bit=2},{"desired_yaw",55,bit=3}},
[41]={"set_local_waypoint",{"presence_vector",7,vector=4},{"waypoint_number",6},{"waypoint_x",59},{"waypoint_y",59},{"waypoint_z",54,bit=0},{"desired_roll",55,bit=1},{"desired_pitch",55,bit=2},{"desired_yaw",55,bit=3}},
[42]={"set_global_path_segment",{"presence_vector",7,vector=2},{"path_segment_number",6},{"p1_latitude",57},{"p1_longitude",58},{"p1_altitude",54,bit=0},{"p2_latitude",57},{"p2_longitude",58},{"p2_altitude",54,bit=1},{"weighting_factor",60}},
[43]={"set_local_path_segment",{"presence_vector",7,vector=2},{"path_segment_number",6},{"p1_x",59},{"p1_y",59},{"p1_z",54,bit=0},{"p2_x",59},{"p2_y",59},{"p2_z",54,bit=1},{"weighting_factor",60}},
[44]={"set_joint_efforts",{"number_of_joints",7,counts=true},{"joint",62}},
[45]={"set_joint_positions",{"number_of_joints",7,counts=true},{"joint",64}},
[46]={"set_joint_velocities",{"number_of_joints",7,counts=true},{"joint",66}},
[47]={"set_tool_point",{"x_coordinate_of_tool_tip",67},{"y_coordinate_of_tool_tip",67},{"z_coordinate_of_tool_tip",67}},
[48]={"set_end_effector_pose",{"x_component_of_tool_point",68},{"y_component_of_tool_point",68},{"z_component_of_tool_point",68},{"d_component_of_unit_quaternion_q",69},{"a_component_of_unit_quaternion_q",69},{"b_component_of_unit_quaternion_q",69},{"c_component_of_unit_quaternion_q",69}},
[49]={"set_end_effector_velocity_state",{"coordinate_system",70},{"angular_velocity_x",71},{"angular_velocity_y",71},{"angular_velocity_z",71},{"linear_velocity_x",72},{"linear_velocity_y",72},{"linear_velocity_z",72}},
[52]={"joint_motion",{"joint_position",63},{"joint_maximum_velocity",65},{"joint_maximum_acceleration",74},{"joint_maximum_deceleration",74}},
[51]={"joint_motion_pose",{"pose_time",73},{"joint",76,counter={50,"number_of_joints"}}},
[50]={"set_joint_motion",{"number_of_joints",7},{"number_of_poses",7,counts=true},{"pose",78}},
[54]={"end_effector_path_pose",{"pose_time",73},{"x_component_of_tool_point",68},{"y_component_of_tool_point",68},{"z_component_of_tool_point",68},{"d_component_of_unit_quaternion_q",69},{"a_component_of_unit_quaternion_q",69},{"b_component_of_unit_quaternion_q",69},{"c_component_of_unit_quaternion_q",69}},
[53]={"set_end_effector_path_motion",{"number_of_poses",7,counts=true},{"pose",80}},
[55]={"set_camera_pose",{"presence_vector",7,vector=6},{"camera_id",7},{"mode_indicator",81},{"linear_x_displacement_or_rate",47,bit=0},{"linear_y_displacement_or_rate",47,bit=1},{"linear_z_displacement_or_rate",47,bit=2},{"angular_x_displacement_or_rate",47,bit=3},{"angular_y_displacement_or_rate",47,bit=4},{"angular_z_displacement_or_rate",47,bit=5}},
[56]={"select_camera",{"camera_id",7}},
[57]={"set_camera_capabilities",{"presence_vector",6,vector=11},{"camera_id",7},{"horizontal_fov",82,bit=0},{"vertical_fov",82,bit=1},{"horizontal_resolution",83,bit=2},{"vertical_resolution",83,bit=3},{"focus",48,bit=4},{"iris",48,bit=5},{"gain",48,bit=6},{"frame_rate",84,bit=7},{"shutter_speed",85,bit=8},{"imaging_controls",86,bit=9},{"audio_controls",87,bit=10}},
[58]={"set_camera_format_options",{"presence_vector",7,vector=3},{"camera_id",7},{"audio_format",88,bit=0},{"image_format",89,bit=1},{"format_options",19,bit=2}},
[61]={"vks_feature_class",{"feature_class_id",6},{"feature_class_attribute",38}},
[62]={"vks_point",{"latitude",57},{"longitude",58}},
[60]={"new_vks_object",{"object_type",91},{"object_buffer",92,gate={59,"object_buffer_present"}},{"number_of_feature_classes",7,counts=true},{"feature_class",94},{"number_of_points",6,counts=true},{"point",96}},
[59]={"create_vector_knowledge_store_objects",{"presence_vector",7,vector=1},{"object_buffer_present",3,flag=true,bit=0},{"message_properties",90},{"local_request_id",7},{"number_of_objects",6,counts=true},{"object",98}},
[63]={"set_vector_knowledge_store_feature_class_metadata",{"metadata_options",99},{"feature_class_id",6},{"number_of_string_characters",6,counts=true},{"feature_class_metadata",100}},
[64]={"terminate_vector_knowledge_store_data_transfer"},
[66]={"vks_feature_class_filter",{"feature_class_id",6,gate={65,"feature_class_id_present"}},{"feature_class_attribute",38,gate={65,"feature_class_attribute_present"}}},
[65]={"delete_vector_knowledge_store_objects",{"presence_vector",7,vector=7},{"local_request_id",7},{"number_of_objects",6,counts=true,bit=0},{"object",101,bit=0},{"region_type",91,bit=1},{"region_buffer",92,bit=2},{"number_of_feature_classes",7,counts=true,bit=3},{"feature_class",103,bit=3},{"feature_class_id_present",3,flag=true,bit=4},{"feature_class_attribute_present",3,flag=true,bit=5},{"number_of_region_points",6,counts=true,bit=6},{"region_point",96,bit=6}},
[67]={"set_payload_data_element",{"number_of_payload_command_elements",7},{"element",104}},
[71]={"embedded_message",{"header",107},{"body",39,counter={0,"header.data_size"}}},
[70]={"mission_command",{"message_uid",6},{"message",108},{"blocking_flag",7}},
[69]={"mission_task",{"task_id",6},{"number_of_children",6},{"child_offset",106,counter={69,"number_of_children"}},{"number_of_messages",6,counts=true},{"message",110}},
[68]={"spool_mission",{"mission_id",6},{"append_flag",105},{"mission_tree",112}},
[72]={"run_mission",{"mission_id",6}},
[73]={"abort_mission",{"mission_id",6},{"task_id",6}},
[74]={"pause_mission",{"mission_id",6},{"task_id",6}},
[75]={"resume_mission",{"mission_id",6},{"task_id",6}},
[76]={"remove_messages",{"mission_id",6},{"task_id",6},{"number_of_messages",6,counts=true},{"message",113}},
[77]={"replace_messages",{"mission_id",6},{"task_id",6},{"number_of_messages_to_remove",6,counts=true},{"removed_message",113},{"number_of_messages_to_insert",6,counts=true},{"inserted_message",110}},
[78]={"query_component_authority"},
[79]={"query_component_status"},
[80]={"query_component_control"},
[81]={"query_time",{"presence_vector",7}},
[82]={"query_events",{"presence_vector",7,vector=3},{"message_code",6,bit=0},{"event_type",27,bit=1},{"event_id",7,bit=2}},
[83]={"query_data_link_status",{"data_link_id",7}},
[84]={"query_selected_data_link_status"},
[85]={"query_heartbeat_pulse"},
[86]={"query_platform_specifications",{"presence_vector",19}},
[87]={"query_platform_operational_data",{"presence_vector",7}},
[88]={"query_global_pose",{"presence_vector",6}},
[89]={"query_local_pose",{"presence_vector",6}},
[90]={"query_velocity_state",{"presence_vector",6}},
[91]={"query_wrench_effort",{"presence_vector",6}},
[92]={"query_discrete_devices",{"presence_vector",7}},
[93]={"query_global_vector",{"presence_vector",7}},
[94]={"query_local_vector"},
[95]={"query_travel_speed"},
[96]={"query_waypoint_count"},
[97]={"query_global_waypoint",{"waypoint_number",6}},
[98]={"query_local_waypoint",{"waypoint_number",6}},
[99]={"query_path_segment_count"},
[100]={"query_global_path_segment",{"path_segment_number",6},{"presence_vector",7}},
[101]={"query_local_path_segment",{"path_segment_number",6},{"presence_vector",7}},
[102]={"query_manipulator_specifications"},
[103]={"query_joint_efforts"},
[104]={"query_joint_positions"},
[105]={"query_joint_velocities"},
[106]={"query_tool_point"},
[107]={"query_joint_force_torques"},
[108]={"query_camera_pose",{"presence_vector",6},{"camera_id",7}},
[109]={"query_camera_count"},
[110]={"query_relative_object_position",{"presence_vector",7}},
[111]={"query_selected_camera"},
[112]={"query_camera_capabilities",{"presence_vector",6},{"camera_id",7}},
[113]={"query_camera_format_options",{"presence_vector",7},{"camera_id",7}},
[114]={"query_image"},
[115]={"query_vector_knowledge_store_feature_class_metadata",{"feature_class_id",6}},
[116]={"query_vector_knowledge_store_bounds",{"local_request_id",7},{"feature_class_id",6}},
[118]={"vks_feature_class_filter",{"feature_class_id",6,gate={117,"feature_class_id_present"}},{"feature_class_attribute",38,gate={117,"feature_class_attribute_present"}}},
[117]={"query_vector_knowledge_store_objects",{"presence_vector",7,vector=7},{"report_presence_vector",7},{"local_request_id",7},{"number_of_objects",6,counts=true,bit=0},{"object",101,bit=0},{"region_type",91,bit=1},{"region_buffer",92,bit=2},{"number_of_feature_classes",7,counts=true,bit=3},{"feature_class",115,bit=3},{"feature_class_id_present",3,flag=true,bit=4},{"feature_class_attribute_present",3,flag=true,bit=5},{"number_of_region_points",6,counts=true,bit=6},{"region_point",96,bit=6}},
[119]={"query_identification",{"query_type",116}},
[120]={"query_configuration",{"query_field",117}},
[121]={"query_subsystem_list"},
[122]={"query_services"},
[123]={"query_payload_interface"},
[124]={"query_payload_data_element",{"number_of_payload_information_elements",7,counts=true},{"element",118}},
[125]={"query_spooling_preference"},
[126]={"query_mission_status",{"presence_vector",7},{"type",119},{"mission_id",6},{"task_id",6},{"message_uid",6}},
[127]={"report_component_authority",{"authority_code",7}},
[128]={"report_component_status",{"primary_status_code",120},{"secondary_status_code",19}},
[129]={"report_component_control",{"subsystem_id",7},{"node_id",7},{"component_id",7},{"instance_id",7},{"authority_code",7}},
[130]={"report_time",{"presence_vector",7,vector=2},{"time_stamp",24,bit=0},{"date_stamp",26,bit=1}},
[132]={"reported_event",{"presence_vector",7,vector=7},{"message_code",6},{"event_type",27},{"event_boundary",28,bit=0},{"limit_data_field",7,bit=1},{"lower_limit",38,bit=2},{"upper_limit",38,bit=3},{"state_limit",38,bit=4},{"event_id",7,bit=5},{"query_message_size",19,counts=true,bit=6},{"query_message",39,bit=6}},
[131]={"report_events",{"number_of_events",7,counts=true},{"event",122}},
[133]={"event",{"event_id",7},{"message_code",6},{"event_sequence_number",7},{"report_message_size",19,counts=true},{"report_message_body",39}},
[134]={"report_data_link_status",{"data_link_id",7},{"state",42}},
[135]={"report_selected_data_link_status",{"data_link_id",7}},
[136]={"report_heartbeat_pulse"},
[137]={"report_platform_specifications",{"presence_vector",19,vector=21},{"platform_name",123,bit=0},{"front",124,bit=1},{"back",124,bit=2},{"right",124,bit=3},{"left",124,bit=4},{"bottom",124,bit=5},{"top",124,bit=6},{"x_cg",124,bit=7},{"y_cg",124,bit=8},{"z_cg",124,bit=9},{"turning_radius",125,bit=10},{"wheel_base",125,bit=11},{"track_width",125,bit=12},{"static_pitch_over",126,bit=13},{"static_roll_over",126,bit=14},{"maximum_velocity_x",127,bit=15},{"maximum_velocity_y",127,bit=16},{"maximum_velocity_z",127,bit=17},{"maximum_roll_rate",128,bit=18},{"maximum_pitch_rate",128,bit=19},{"maximum_yaw_rate",128,bit=20}},
[138]={"report_platform_operational_data",{"presence_vector",7,vector=5},{"engine_temperature",129,bit=0},{"odometer",130,bit=1},{"battery_voltage",131,bit=2},{"fuel_level",48,bit=3},{"oil_pressure",131,bit=4}},
[139]={"report_global_pose",{"presence_vector",6,vector=9,tolerant=true},{"latitude",57,bit=0},{"longitude",58,bit=1},{"elevation",54,bit=2},{"position_rms",132,bit=3},{"roll",55,bit=4},{"pitch",55,bit=5},{"yaw",55,bit=6},{"attitude_rms",82,bit=7},{"time_stamp",24,bit=8}},
[140]={"report_local_pose",{"presence_vector",6,vector=9},{"x",59,bit=0},{"y",59,bit=1},{"z",54,bit=2},{"position_rms",132,bit=3},{"roll",55,bit=4},{"pitch",55,bit=5},{"yaw",55,bit=6},{"attitude_rms",82,bit=7},{"time_stamp",24,bit=8}},
[141]={"report_velocity_state",{"presence_vector",6,vector=9,tolerant=true},{"velocity_x",43,bit=0},{"velocity_y",43,bit=1},{"velocity_z",43,bit=2},{"velocity_rms",44,bit=3},{"roll_rate",45,bit=4},{"pitch_rate",45,bit=5},{"yaw_rate",45,bit=6},{"rate_rms",46,bit=7},{"time_stamp",24,bit=8}},
[142]={"report_wrench_effort",{"presence_vector",6,vector=12},{"propulsive_linear_effort_x",47,bit=0},{"propulsive_linear_effort_y",47,bit=1},{"propulsive_linear_effort_z",47,bit=2},{"propulsive_rotational_effort_x",47,bit=3},{"propulsive_rotational_effort_y",47,bit=4},{"propulsive_rotational_effort_z",47,bit=5},{"resistive_linear_effort_x",48,bit=6},{"resistive_linear_effort_y",48,bit=7},{"resistive_linear_effort_z",48,bit=8},{"resistive_rotational_effort_x",48,bit=9},{"resistive_rotational_effort_y",48,bit=10},{"resistive_rotational_effort_z",48,bit=11}},
[143]={"report_discrete_devices",{"presence_vector",7,vector=4},{"main_propulsion",49,bit=0},{"parking_brake_and_horn",50,bit=1},{"gear",51,bit=2},{"transfer_case",52,bit=3}},
[144]={"report_global_vector",{"presence_vector",7,vector=5},{"desired_speed",53,bit=0},{"desired_elevation",54,bit=1},{"desired_heading",55,bit=2},{"desired_roll",55,bit=3},{"desired_pitch",55,bit=4}},
[145]={"report_local_vector",{"desired_speed",56},{"desired_heading",55}},
[146]={"report_travel_speed",{"desired_speed",53}},
[147]={"report_waypoint_count",{"waypoint_count",6}},
[148]={"report_global_waypoint",{"presence_vector",7,vector=4},{"waypoint_number",6},{"latitude",57},{"longitude",58},{"altitude",54,bit=0},{"desired_roll",55,bit=1},{"desired_pitch",55,bit=2},{"desired_yaw",55,bit=3}},
[149]={"report_local_waypoint",{"presence_vector",7,vector=4},{"waypoint_number",6},{"waypoint_x",59},{"waypoint_y",59},{"waypoint_z",54,bit=0},{"desired_roll",55,bit=1},{"desired_pitch",55,bit=2},{"desired_yaw",55,bit=3}},
[150]={"report_path_segment_count",{"path_segment_count",6}},
[151]={"report_global_path_segment",{"presence_vector",7,vector=2},{"path_segment_number",6},{"p1_latitude",57},{"p1_longitude",58},{"p1_altitude",54,bit=0},{"p2_latitude",57},{"p2_longitude",58},{"p2_altitude",54,bit=1},{"weighting_factor",60}},
[152]={"report_local_path_segment",{"presence_vector",7,vector=2},{"path_segment_number",6},{"p1_x",59},{"p1_y",59},{"p1_z",54,bit=0},{"p2_x",59},{"p2_y",59},{"p2_z",54,bit=1},{"weighting_factor",60}},
[154]={"joint_specification",{"joint_type",133},{"link_length",134},{"twist_angle",135},{"joint_offset",6},{"joint_minimum_value",6},{"joint_maximum_value",6},{"joint_maximum_velocity",6}},
[153]={"report_manipulator_specifications",{"number_of_joints",7},{"joint_n_type",133},{"joint_n_offset",6},{"joint_n_minimum_value",6},{"joint_n_maximum_value",6},{"joint_n_maximum_velocity",6},{"manipulator_coordinate_system_x",68},{"manipulator_coordinate_system_y",68},{"manipulator_coordinate_system_z",68},{"d_component_of_unit_quaternion_q",69},{"a_component_of_unit_quaternion_q",69},{"b_component_of_unit_quaternion_q",69},{"c_component_of_unit_quaternion_q",69},{"joint",137,counter={153,"number_of_joints"},excess=1}},
[155]={"report_joint_efforts",{"number_of_joints",7,counts=true},{"joint",62}},
[156]={"report_joint_positions",{"number_of_joints",7,counts=true},{"joint",64}},
[157]={"report_joint_velocities",{"number_of_joints",7,counts=true},{"joint",66}},
[158]={"report_tool_point",{"x_coordinate_of_tool_tip",67},{"y_coordinate_of_tool_tip",67},{"z_coordinate_of_tool_tip",67}},
[159]={"report_joint_force_torques",{"number_of_joints",7,counts=true},{"joint",139}},
[160]={"report_camera_pose",{"presence_vector",6,vector=10},{"camera_id",7},{"camera_name",123,bit=0},{"x_camera_origin",140,bit=1},{"y_camera_origin",140,bit=2},{"z_camera_origin",140,bit=3},{"x_camera_axis_direction_cosine_x",141,bit=4},{"x_camera_axis_direction_cosine_y",141,bit=5},{"x_camera_axis_direction_cosine_z",141,bit=6},{"z_camera_axis_direction_cosine_x",141,bit=7},{"z_camera_axis_direction_cosine_y",141,bit=8},{"z_camera_axis_direction_cosine_z",141,bit=9}},
[161]={"report_camera_count",{"camera_count",7}},
[162]={"report_relative_object_position",{"presence_vector",7,vector=8},{"time_stamp",24},{"range",142,bit=0},{"range_error",143,bit=1},{"bearing",144,bit=2},{"bearing_error",145,bit=3},{"inclination",144,bit=4},{"inclination_error",145,bit=5},{"confidence",7,bit=6},{"object_id",6,bit=7}},
[163]={"report_selected_camera",{"camera_id",7}},
[164]={"report_camera_capabilities",{"presence_vector",6,vector=15},{"camera_id",7},{"description",146,bit=0},{"maximum_horizontal_fov",82,bit=1},{"minimum_horizontal_fov",82,bit=2},{"maximum_vertical_fov",82,bit=3},{"minimum_vertical_fov",82,bit=4},{"maximum_horizontal_resolution",83,bit=5},{"minimum_horizontal_resolution",83,bit=6},{"maximum_vertical_resolution",83,bit=7},{"minimum_vertical_resolution",83,bit=8},{"maximum_frame_rate",84,bit=9},{"minimum_frame_rate",84,bit=10},{"maximum_shutter_speed",85,bit=11},{"minimum_shutter_speed",85,bit=12},{"imaging_controls",86,bit=13},{"audio_controls",87,bit=14}},
[165]={"report_camera_format_options",{"presence_vector",7,vector=7},{"camera_id",7},{"audio_format_1",88,bit=0},{"audio_format_2",88,bit=1},{"image_format_1",89,bit=2},{"image_format_2",89,bit=3},{"image_format_3",89,bit=4},{"image_format_4",89,bit=5},{"format_options",19,bit=6}},
[166]={"report_image",{"camera_id",7},{"video_format",89},{"image_data",104}},
[167]={"report_vector_knowledge_store_objects_creation",{"local_request_id",7},{"number_of_objects",6,counts=true},{"object",101}},
[168]={"report_vector_knowledge_store_feature_class_metadata",{"feature_class_id",6},{"number_of_string_characters",6,counts=true},{"feature_class_metadata",100}},
[169]={"report_vector_knowledge_store_bounds",{"local_request_id",7},{"feature_class_id",6},{"southwest_latitude",57},{"southwest_longitude",58},{"northeast_latitude",57},{"northeast_longitude",58}},
[171]={"vks_object",{"object_id",19},{"object_type",91},{"object_buffer",92},{"number_of_feature_classes",7,counts=true},{"feature_class",94},{"number_of_points",6,counts=true},{"point",96}},
[170]={"report_vector_knowledge_store_objects",{"presence_vector",7,vector=1},{"local_request_id",7},{"number_of_objects",6},{"object",148,bit=0,counter={170,"number_of_objects"}}},
[172]={"report_vector_knowledge_store_data_transfer_termination"},
[173]={"report_identification",{"query_type",116},{"authority_code",7},{"type",6},{"identification",149}},
[176]={"configured_component",{"component_id",7},{"instance_id",7}},
[175]={"configured_node",{"node_id",7},{"number_of_components",7,counts=true},{"component",151}},
[174]={"report_configuration",{"number_of_nodes",7,counts=true},{"node",153}},
[178]={"listed_subsystem",{"subsystem_id",7},{"node_id",7},{"component_id",7},{"instance_id",7}},
[177]={"report_subsystem_list",{"number_of_subsystems",7,counts=true},{"subsystem",155}},
[181]={"supported_message",{"command_code",6},{"supported_presence_vector",19}},
[180]={"offered_service",{"service_type",6},{"number_of_input_messages",7,counts=true},{"input_message",157},{"number_of_output_messages",7,counts=true},{"output_message",157}},
[179]={"report_services",{"number_of_services",7,counts=true},{"service",159}},
[184]={"payload_tuple",{"first",7},{"second",7}},
[185]={"payload_tuple",{"first",6},{"second",6}},
[186]={"payload_tuple",{"first",19},{"second",19}},
[183]={"payload_command_interface",{"command_identifier",160},{"type_code",161},{"units",7},{"blocking_flag",162},{"minimum_value",166,tag={183,"type_code"}},{"default_value",166,tag={183,"type_code"}},{"maximum_value",166,tag={183,"type_code"}},{"enumeration_length",6,counts=true},{"enumeration",100},{"hmi_recommendation",7,gate={182,"hmi_recommendation_present"}},{"hmi_recommended_x_position",83,gate={182,"hmi_recommended_x_position_present"}},{"hmi_recommended_y_position",83,gate={182,"hmi_recommended_y_position_present"}},{"hmi_recommended_width",83,gate={182,"hmi_recommended_width_present"}},{"hmi_recommended_height",83,gate={182,"hmi_recommended_height_present"}}},
[187]={"payload_information_interface",{"information_identifier",160},{"command_interface_association",7},{"type_code",161},{"units",7},{"minimum_value",166,tag={187,"type_code"}},{"default_value",166,tag={187,"type_code"}},{"maximum_value",166,tag={187,"type_code"}},{"enumeration_length",6,counts=true},{"enumeration",100},{"hmi_recommendation",7,gate={182,"hmi_recommendation_present"}},{"hmi_recommended_x_position",83,gate={182,"hmi_recommended_x_position_present"}},{"hmi_recommended_y_position",83,gate={182,"hmi_recommended_y_position_present"}},{"hmi_recommended_width",83,gate={182,"hmi_recommended_width_present"}},{"hmi_recommended_height",83,gate={182,"hmi_recommended_height_present"}}},
[182]={"report_payload_interface",{"presence_vector",7,vector=5},{"hmi_recommendation_present",3,flag=true,bit=0},{"hmi_recommended_x_position_present",3,flag=true,bit=1},{"hmi_recommended_y_position_present",3,flag=true,bit=2},{"hmi_recommended_width_present",3,flag=true,bit=3},{"hmi_recommended_height_present",3,flag=true,bit=4},{"number_of_command_interfaces",7},{"number_of_information_interfaces",7},{"command_interface",168,counter={182,"number_of_command_interfaces"}},{"information_interface",170,counter={182,"number_of_information_interfaces"}}},
[188]={"report_payload_data_element",{"number_of_payload_information_elements",7},{"element",104}},
[189]={"report_spooling_preference",{"spooling_preference_type",171},{"data",31}},
[190]={"report_mission_status",{"type",119},{"status",172},{"secondary_status",173},{"mission_id",6},{"task_id",6},{"message_uid",6}},
[191]={"set_authority",{"authority_code",7}},
[192]={"shutdown"},
[193]={"standby"},
[194]={"resume"},
[195]={"reset"},
[196]={"set_emergency",{"emergency_code",174}},
[197]={"clear_emergency",{"emergency_code",174}},
[198]={"request_control",{"authority_code",7}},
[199]={"release_control"},
[200]={"confirm_control",{"response_code",175}},
[201]={"reject_control",{"response_code",176}},
[202]={"create_event",{"request_id",7},{"event_type",177},{"requested_periodic_rate",178},{"query_message_size",179,counts=true},{"query_message",180}},
[203]={"update_event",{"request_id",7},{"event_type",177},{"requested_periodic_rate",178},{"event_id",7},{"query_message_size",179,counts=true},{"query_message",180}},
[204]={"cancel_event",{"request_id",7},{"event_id",7}},
[205]={"confirm_event_request",{"request_id",7},{"event_id",7},{"confirmed_periodic_rate",178}},
[206]={"reject_event_request",{"presence_vector",7,vector=2},{"request_id",7},{"response_code",181,bit=0},{"error_message",182,bit=1}},
[207]={"create_command_event",{"request_id",7},{"maximum_allowed_duration",183},{"command_message_size",179,counts=true},{"command_message",180}},
[209]={"time_stamp",{"milliseconds",190,first=0,carrier=32},{"seconds",191,first=10,carrier=32},{"minutes",191,first=16,carrier=32},{"hour",192,first=22,carrier=32},{"day",193,first=27,carrier=32,ends=true}},
[208]={"set_global_pose",{"presence_vector",6,vector=9},{"latitude",184,bit=0},{"longitude",185,bit=1},{"altitude",186,bit=2},{"position_rms",187,bit=3},{"roll",188,bit=4},{"pitch",188,bit=5},{"yaw",188,bit=6},{"attitude_rms",189,bit=7},{"time_stamp",194,bit=8}},
[210]={"set_wrench_effort",{"presence_vector",6,vector=12},{"propulsive_linear_effort_x",195,bit=0},{"propulsive_linear_effort_y",195,bit=1},{"propulsive_linear_effort_z",195,bit=2},{"propulsive_rotational_effort_x",195,bit=3},{"propulsive_rotational_effort_y",195,bit=4},{"propulsive_rotational_effort_z",195,bit=5},{"resistive_linear_effort_x",196,bit=6},{"resistive_linear_effort_y",196,bit=7},{"resistive_linear_effort_z",196,bit=8},{"resistive_rotational_effort_x",196,bit=9},{"resistive_rotational_effort_y",196,bit=10},{"resistive_rotational_effort_z",196,bit=11}},
[211]={"set_global_vector",{"presence_vector",7,vector=5},{"speed",197,bit=0},{"altitude",186,bit=1},{"heading",188,bit=2},{"roll",188,bit=3},{"pitch",188,bit=4}},
[212]={"set_local_vector",{"presence_vector",7,vector=4},{"speed",197},{"z",186,bit=0},{"heading",188,bit=1},{"roll",188,bit=2},{"pitch",188,bit=3}},
[213]={"set_travel_speed",{"speed",197}},
[214]={"set_global_waypoint",{"presence_vector",7,vector=6},{"latitude",184},{"longitude",185},{"altitude",186,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"yaw",188,bit=3},{"waypoint_tolerance",198,bit=4},{"path_tolerance",199,bit=5}},
[215]={"set_local_waypoint",{"presence_vector",7,vector=6},{"x",200},{"y",200},{"z",200,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"yaw",188,bit=3},{"waypoint_tolerance",198,bit=4},{"path_tolerance",199,bit=5}},
[216]={"set_geomagnetic_property",{"magnetic_variation",188}},
[218]={"request_id_rec",{"request_id",7}},
[220]={"element_data",{"format",202},{"data_size",6,counts=true},{"data",180}},
[219]={"element_rec",{"element_uid",6},{"previous_uid",6},{"next_uid",6},{"element_data",203}},
[217]={"set_element",{"request_id_rec",201},{"number_of_element_list",7,counts=true},{"element_list",205}},
[222]={"delete_element_rec",{"element_uid",6}},
[221]={"delete_element",{"request_id_rec",201},{"number_of_delete_element_list",7,counts=true},{"delete_element_list",207}},
[223]={"confirm_element_request",{"request_id",7}},
[224]={"reject_element_request",{"request_id",7},{"response_code",208}},
[225]={"execute_list",{"presence_vector",7,vector=1},{"speed",197},{"element_uid",6,bit=0}},
[227]={"zone_id_rec",{"zone_id",209}},
[226]={"delete_zone",{"number_of_zone_id_list",7,counts=true},{"zone_id_list",211}},
[230]={"global_operating_zone_min_z_position",{"index",212},{"value",214,tag={230,"index"}}},
[231]={"global_operating_zone_max_z_position",{"index",212},{"value",214,tag={231,"index"}}},
[229]={"global_polygon_point_rec",{"presence_vector",7,vector=2},{"latitude",184},{"longitude",185},{"min_z_position",215,bit=0},{"max_z_position",216,bit=1}},
[234]={"global_exclusion_zone_rec",{"zone_id",209}},
[233]={"global_exclusion_zone_seq",{"global_exclusion_zone_rec",219},{"global_polygon_point_rec",217}},
[232]={"global_exclusion_zone",{"number_of_elements",7,counts=true},{"elements",221}},
[228]={"set_global_operating_zone",{"number_of_global_operating_zone",7,counts=true},{"global_operating_zone",218},{"number_of_global_exclusion_zones",7,counts=true},{"global_exclusion_zones",223}},
[237]={"global_loiter_driver_z_position",{"index",212},{"value",214,tag={237,"index"}}},
[236]={"global_loiter_rec",{"presence_vector",7,vector=1},{"latitude",184},{"longitude",185},{"z_position",224,bit=0}},
[238]={"global_loiter_driver_hover_rec",{"hover_preference",226},{"xy_tolerance",199},{"z_tolerance",227}},
[239]={"polygon_rec",{"number_loiter_vertices",7},{"xy_extent",199},{"loiter_direction",229},{"loiter_bearing",189}},
[240]={"race_track_rec",{"loiter_type",231},{"loiter_radius",232},{"loiter_length",232},{"loiter_direction",229},{"loiter_bearing",189}},
[235]={"set_global_loiter",{"global_loiter_rec",225},{"loiter",234}},
[243]={"local_loiter_driver_z_position",{"index",236},{"value",237,tag={243,"index"}}},
[242]={"local_loiter_rec",{"presence_vector",7,vector=1},{"x",235},{"y",235},{"z_position",238,bit=0}},
[244]={"local_loiter_driver_hover_rec",{"hover_preference",240},{"xy_tolerance",199},{"z_tolerance",227}},
[241]={"set_local_loiter",{"local_loiter_rec",239},{"loiter",242}},
[247]={"local_operating_zone_min_z_position",{"index",236},{"value",237,tag={247,"index"}}},
[248]={"local_operating_zone_max_z_position",{"index",236},{"value",237,tag={248,"index"}}},
[246]={"local_polygon_point_rec",{"presence_vector",7,vector=2},{"x",235},{"y",235},{"min_z_position",243,bit=0},{"max_z_position",244,bit=1}},
[251]={"local_exclusion_zone_rec",{"zone_id",209}},
[250]={"local_exclusion_zone_seq",{"local_exclusion_zone_rec",247},{"local_polygon_point_rec",245}},
[249]={"local_exclusion_zone",{"number_of_elements",7,counts=true},{"elements",249}},
[245]={"set_local_operating_zone",{"number_of_local_operating_zone",7,counts=true},{"local_operating_zone",246},{"number_of_local_exclusion_zones",7,counts=true},{"local_exclusion_zones",251}},
[252]={"request_gps_fix"},
[253]={"inertial_sensor_control",{"command",252}},
[255]={"global_pose_sensor_z_position",{"index",212},{"value",214,tag={255,"index"}}},
[254]={"set_global_pose_ext",{"presence_vector",6,vector=11},{"latitude",184,bit=0},{"longitude",185,bit=1},{"z_position",253,bit=2},{"horizontal_rms",187,bit=3},{"vertical_rms",187,bit=4},{"roll",188,bit=5},{"pitch",188,bit=6},{"heading",188,bit=7},{"attitude_rms",189,bit=8},{"time_seconds",183,bit=9},{"time_nano_seconds",19,bit=10}},
[257]={"speed",{"index",254},{"value",257,tag={257,"index"}}},
[258]={"global_vector_driver_z_position",{"index",212},{"value",214,tag={258,"index"}}},
[256]={"set_global_vector_ext",{"presence_vector",7,vector=5},{"speed",258},{"z_position",259,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"heading",188,bit=3},{"course",188,bit=4}},
[260]={"local_vector_driver_z_position",{"index",236},{"value",237,tag={260,"index"}}},
[259]={"set_local_vector_ext",{"presence_vector",7,vector=5},{"speed",258},{"z_position",260,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"heading",188,bit=3},{"course",188,bit=4}},
[261]={"set_travel_speed_ext",{"speed",258}},
[263]={"global_waypoint_driver_z_position",{"index",212},{"value",214,tag={263,"index"}}},
[262]={"set_global_waypoint_ext",{"presence_vector",7,vector=6},{"latitude",184},{"longitude",185},{"z_position",261,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"heading",188,bit=3},{"waypoint_tolerance",262,bit=4},{"path_tolerance",199,bit=5}},
[265]={"local_waypoint_driver_z_position",{"index",236},{"value",237,tag={265,"index"}}},
[264]={"set_local_waypoint_ext",{"presence_vector",7,vector=6},{"x",235},{"y",235},{"z_position",263,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"heading",188,bit=3},{"waypoint_tolerance",262,bit=4},{"path_tolerance",199,bit=5}},
[266]={"execute_list_ext",{"presence_vector",7,vector=1},{"speed",258},{"element_uid",6,bit=0}},
[267]={"set_ackermann_configuration",{"presence_vector",7,vector=2},{"steering_angle",264},{"throttle_effort",265},{"brake_effort",265},{"max_steering_rate",266,bit=0},{"max_steering_torque",267,bit=1}},
[268]={"set_skid_steer_effort",{"left_side_propulsive_effort",268},{"right_side_propulsive_effort",268}},
[270]={"stabilizer_effort_rec",{"stabilizer_id",7},{"effort",268}},
[269]={"set_stabilizer_effort",{"number_of_stabilizer_effort",7,counts=true},{"stabilizer_effort",270}},
[272]={"set_stabilizer_position_stabilizer_position_rec",{"stabilizer_id",7},{"position",271}},
[271]={"set_stabilizer_position",{"number_of_stabilizer_position",7,counts=true},{"stabilizer_position",273}},
[275]={"power_plant_id_record",{"power_plant_id",7}},
[276]={"gas_engine_configuration_rec",{"presence_vector",7,vector=2},{"power_state",275},{"rpm",6,bit=0},{"throttle",265,bit=1}},
[277]={"diesel_engine_configuration_rec",{"presence_vector",7,vector=3},{"power_state",275},{"rpm",6,bit=0},{"throttle",265,bit=1},{"plug_state",277,bit=2}},
[278]={"battery_configuration_rec",{"power_state",275}},
[279]={"hydraulic_configuration_rec",{"power_state",275}},
[280]={"fuel_cell_configuration_recs",{"power_state",275}},
[274]={"power_plant_configuration_seq",{"power_plant_id",274},{"power_plant_configuration_var",282}},
[273]={"set_power_plant_configuration",{"number_of_power_plant_configuration_list",7,counts=true},{"power_plant_configuration_list",284}},
[281]={"set_parking_brake",{"parking_brake",285}},
[283]={"illumination",{"headlights",286,first=0,carrier=32},{"left_turn_signal",286,first=1,carrier=32},{"right_turn_signal",286,first=2,carrier=32},{"running_lights",286,first=3,carrier=32},{"brake_lights",286,first=4,carrier=32},{"backup_lights",286,first=5,carrier=32},{"visible_light_source",286,first=6,carrier=32},{"ir_light_source",286,first=7,carrier=32},{"variable_light1",1,first=8,carrier=32},{"variable_light2",1,first=12,carrier=32},{"variable_light3",1,first=16,carrier=32},{"variable_light4",1,first=20,carrier=32},{"high_beams",286,first=24,carrier=32},{"parking_lights",286,first=25,carrier=32},{"fog_lights",286,first=26,carrier=32},{"hazard_lights",286,first=27,carrier=32,ends=true}},
[282]={"set_illumination_state",{"illumination",287}},
[284]={"reset_odometry",{"odometry_type",288}},
[286]={"joint_effort_rec",{"joint_effort",268}},
[285]={"set_joint_effort",{"number_of_joint_effort_list",7,counts=true},{"joint_effort_list",290}},
[289]={"joint_position",{"index",291},{"value",294,tag={289,"index"}}},
[288]={"joint_position_rec",{"joint_position",295}},
[287]={"set_joint_positions",{"number_of_joint_position_list",7,counts=true},{"joint_position_list",297}},
[292]={"joint_velocity",{"index",298},{"value",301,tag={292,"index"}}},
[291]={"joint_velocity_rec",{"joint_velocity",302}},
[290]={"set_joint_velocity",{"number_of_joint_velocity_list",7,counts=true},{"joint_velocity_list",304}},
[293]={"set_end_effector_pose",{"tool_point_coordinate_x",305},{"tool_point_coordinate_y",305},{"tool_point_coordinate_z",305},{"d_component_of_unit_quaternion_q",69},{"a_component_of_unit_quaternion_q",69},{"b_component_of_unit_quaternion_q",69},{"c_component_of_unit_quaternion_q",69}},
[294]={"set_end_effector_velocity_state",{"angular_velocity_component_x",306},{"angular_velocity_component_y",306},{"angular_velocity_component_z",306},{"linear_velocity_component_x",307},{"linear_velocity_component_y",307},{"linear_velocity_component_z",307}},
[297]={"joint_force_torque",{"index",308},{"value",311,tag={297,"index"}}},
[296]={"actuator_force_torque_rec",{"joint_force_torque",312}},
[295]={"set_actuator_force_torques",{"number_of_actuator_force_torque_list",7,counts=true},{"actuator_force_torque_list",314}},
[298]={"execute_list",{"presence_vector",7,vector=1},{"element_uid",6,bit=0}},
[299]={"set_pan_tilt_joint_effort",{"joint1_effort",268},{"joint2_effort",268}},
[300]={"set_pan_tilt_joint_positions",{"joint1_position",292},{"joint2_position",292}},
[301]={"set_pan_tilt_motion_profile",{"joint1_max_speed",315},{"joint1_max_acceleration_rate",316},{"joint1_max_deceleration_rate",316},{"joint2_max_speed",315},{"joint2_max_acceleration_rate",316},{"joint2_max_deceleration_rate",316}},
[303]={"shared_request_id_rec",{"request_id",7}},
[305]={"shared_sensor_id_rec",{"sensor_id",318}},
[306]={"range_sensor_error_rec",{"sensor_id",318},{"range_sensor_error_code",320},{"error_message_size",7,counts=true},{"error_message",100}},
[307]={"visual_sensor_error_rec",{"sensor_id",318},{"visual_sensor_error_code",322},{"error_message_size",7,counts=true},{"error_message",100}},
[308]={"digital_video_sensor_error_rec",{"sensor_id",318},{"digital_video_error_code",324},{"error_message_size",7,counts=true},{"error_message",100}},
[309]={"analog_video_sensor_error_rec",{"sensor_id",318},{"analog_video_error_code",326},{"error_message_size",7,counts=true},{"error_message",100}},
[310]={"still_image_sensor_error_rec",{"sensor_id",318},{"still_image_error_code",328},{"error_message_size",7,counts=true},{"error_message",100}},
[311]={"h264_video_encoding_error_rec",{"sensor_id",318},{"h264_video_encoding_error_code",330},{"error_message_size",7,counts=true},{"error_message",100}},
[312]={"digital_audio_sensor_error_rec",{"sensor_id",318},{"digital_audio_sensor_error_code",332},{"error_message_size",7,counts=true},{"error_message",100}},
[313]={"digital_audio_output_error_rec",{"sensor_id",318},{"digital_audio_output_error_code",334},{"error_message_size",7,counts=true},{"error_message",100}},
[314]={"video_illuminator_error_rec",{"illuminator_id",6},{"video_illuminator_error_rec_code",336},{"error_message_size",7,counts=true},{"error_message",100}},
[304]={"confirm_sensor_configuration_variant",{"value",338}},
[302]={"confirm_sensor_configuration",{"request_id_rec",317},{"number_of_confirm_sensor_list",6,counts=true},{"confirm_sensor_list",340}},
[316]={"range_sensor_request_id_rec",{"request_id",7}},
[317]={"range_sensor_configuration_rec",{"presence_vector",7,vector=8},{"sensor_id",318},{"horizontal_field_of_view_start_angle",342,bit=0},{"horizontal_field_of_view_stop_angle",342,bit=1},{"vertical_field_of_view_start_angle",342,bit=2},{"vertical_field_of_view_stop_angle",342,bit=3},{"update_rate",343,bit=4},{"minimum_range",344,bit=5},{"maximum_range",344,bit=6},{"sensor_state",345,bit=7}},
[315]={"set_range_sensor_configuration",{"request_id_rec",341},{"number_of_range_sensor_configuration_list",6,counts=true},{"range_sensor_configuration_list",347}},
[319]={"visual_sensor_request_id_rec",{"request_id",7}},
[320]={"visual_sensor_configuration_rec",{"presence_vector",6,vector=16},{"sensor_id",318},{"sensor_state",345,bit=0},{"zoom_mode",349,bit=1},{"zoom_level",350,bit=2},{"focal_length",351,bit=3},{"horizontal_field_of_view",342,bit=4},{"vertical_field_of_view",342,bit=5},{"focus_mode",352,bit=6},{"focus_value",350,bit=7},{"white_balance",353,bit=8},{"imaging_mode",354,bit=9},{"exposure_mode",355,bit=10},{"metering_mode",356,bit=11},{"shutter_speed",357,bit=12},{"aperture",358,bit=13},{"light_sensitivity",359,bit=14},{"image_stabilization",360,bit=15}},
[318]={"set_visual_sensor_configuration",{"request_id_rec",348},{"number_of_visual_sensor_configuration_list",6,counts=true},{"visual_sensor_configuration_list",362}},
[322]={"digital_video_request_id_rec",{"request_id",7}},
[323]={"digital_video_sensor_configuration_rec",{"presence_vector",7,vector=5},{"sensor_id",318},{"minimum_bit_rate",6,bit=0},{"maximum_bit_rate",6,bit=1},{"frame_rate",7,bit=2},{"frame_size",364,bit=3},{"digital_format",365,bit=4}},
[321]={"set_digital_video_sensor_configuration",{"request_id_rec",363},{"number_of_digital_video_sensor_list",6,counts=true},{"digital_video_sensor_list",367}},
[324]={"control_digital_video_sensor_stream",{"sensor_id",318},{"stream_state",368}},
[326]={"analog_video_request_id_rec",{"request_id",7}},
[327]={"analog_video_sensor_configuration_rec",{"sensor_id",318},{"analog_format",370}},
[325]={"set_analog_video_sensor_configuration",{"request_id_rec",369},{"number_of_analog_video_sensor_list",6,counts=true},{"analog_video_sensor_list",372}},
[329]={"still_image_request_id_rec",{"request_id",7}},
[330]={"still_image_sensor_configuration_rec",{"presence_vector",7,vector=2},{"sensor_id",318},{"frame_size",364,bit=0},{"still_image_format",374,bit=1}},
[328]={"set_still_image_sensor_configuration",{"request_id_rec",373},{"number_of_still_image_sensor_list",6,counts=true},{"still_image_sensor_list",376}},
[332]={"digital_resource_discovery_request_id_rec",{"request_id",7}},
[334]={"jaus_id",{"component_id",7,first=0,carrier=32},{"node_id",7,first=8,carrier=32},{"subsystem_id",6,first=16,carrier=32,ends=true}},
[333]={"digital_resource_endpoint_rec",{"presence_vector",7,vector=2},{"server_type",378},{"server_url_size",7,counts=true},{"server_url",100},{"jaus_id",379,bit=0},{"resource_id",6,bit=1}},
[331]={"register_digital_resource_endpoint",{"request_id_rec",377},{"digital_resource_endpoint_rec",380}},
[335]={"remove_digital_resource_endpoint",{"id",7},{"request_id",7}},
[336]={"confirm_digital_resource_endpoint",{"id",7},{"request_id",7}},
[337]={"control_digital_video_sensor_recording",{"sensor_id",318},{"requested_recording_state",381}},
[339]={"digital_audio_output_request_id_rec",{"request_id",7}},
[340]={"digital_audio_output_source_rec",{"sensor_id",318},{"stream_url_size",7,counts=true},{"stream_url",100},{"repeat",383},{"volume",350}},
[338]={"set_digital_audio_output_source",{"request_id_rec",382},{"number_of_digital_audio_output_source_list",6,counts=true},{"digital_audio_output_source_list",385}},
[342]={"video_illuminator_request_id_rec",{"request_id",7}},
[343]={"illuminator_rec",{"presence_vector",7,vector=3},{"illuminator_id",6},{"level",350},{"mode",387,bit=0},{"beam_width",388,bit=1},{"beam_height",388,bit=2}},
[341]={"set_video_illuminator_configuration",{"request_id_rec",386},{"number_of_illuminator_list",6,counts=true},{"illuminator_list",390}},
[345]={"service_rec",{"uri_size",7,counts=true},{"uri",100},{"major_version_number",7},{"minor_version_number",7}},
[344]={"register_services",{"number_of_service_list",7,counts=true},{"service_list",392}},
[346]={"query_authority"},
[347]={"query_status"},
[348]={"query_timeout"},
[349]={"query_control"},
[351]={"message_id_rec",{"message_code",6}},
[352]={"event_type_rec",{"event_type",177}},
[353]={"event_id_rec",{"event_id",7}},
[354]={"all_events_rec",{"all_events",396}},
[350]={"query_events",{"query_events_var",398}},
[355]={"query_event_timeout"},
[356]={"query_heartbeat_pulse"},
[357]={"query_global_pose",{"presence_vector",6}},
[358]={"query_velocity_state",{"presence_vector",6}},
[359]={"query_wrench_effort",{"presence_vector",6}},
[360]={"query_global_vector",{"presence_vector",7}},
[361]={"query_local_vector",{"presence_vector",7}},
[362]={"query_travel_speed"},
[363]={"query_global_waypoint",{"presence_vector",7}},
[364]={"query_local_waypoint",{"presence_vector",7}},
[365]={"query_global_path_segment",{"presence_vector",7}},
[366]={"query_local_path_segment",{"presence_vector",7}},
[367]={"query_geomagnetic_property"},
[368]={"query_acceleration_state",{"presence_vector",6}},
[369]={"query_element",{"element_uid",6}},
[370]={"query_element_list"},
[371]={"query_element_count"},
[372]={"query_active_element"},
[373]={"query_global_operating_zone",{"query_zone_id",399}},
[374]={"query_excursion",{"query_zone_id",399}},
[375]={"query_global_loiter",{"presence_vector",7}},
[376]={"query_local_loiter",{"presence_vector",7}},
[377]={"query_local_operating_zone",{"query_zone_id",399}},
[378]={"query_gps_fix"},
[379]={"query_inertial_sensor_status"},
[380]={"query_global_pose_ext",{"presence_vector",6}},
[381]={"query_velocity_state_ext",{"velocity_var_presence_vector",7},{"report_velocity_state_ext_rec_presence_vector",6}},
[382]={"query_global_vector_ext",{"presence_vector",6}},
[383]={"query_local_vector_ext",{"presence_vector",6}},
[384]={"query_travel_speed_ext"},
[385]={"query_global_waypoint_ext",{"presence_vector",6}},
[386]={"query_local_waypoint_ext",{"presence_vector",6}},
[387]={"query_global_path_segment_ext",{"presence_vector",7}},
[388]={"query_local_path_segment_ext",{"presence_vector",7}},
[389]={"query_acceleration_state_ext",{"presence_vector",6}},
[390]={"query_ackermann_configuration"},
[391]={"query_skid_steer_effort"},
[392]={"query_platform_specifications"},
[394]={"query_stabilizer_rec",{"stabilizer_id",7}},
[393]={"query_stabilizer_effort",{"number_of_stabilizer_id",7,counts=true},{"stabilizer_id",401}},
[395]={"query_stabilizer_position",{"number_of_stabilizer_id",7,counts=true},{"stabilizer_id",401}},
[396]={"query_stabilizer_capabilities"},
[397]={"query_power_plant_configuration",{"number_of_id_list",7,counts=true},{"id_list",402}},
[398]={"query_power_plant_capabilities",{"number_of_id_list",7,counts=true},{"id_list",402}},
[399]={"query_power_plant_status",{"number_of_id_list",7,counts=true},{"id_list",402}},
[400]={"query_parking_brake"},
[401]={"query_illumination_state"},
[402]={"query_illumination_configuration"},
[403]={"query_odometry",{"odom",403}},
[404]={"query_manipulator_specifications",{"presence_vector",7}},
[405]={"query_joint_effort"},
[406]={"query_joint_velocity"},
[407]={"query_joint_force_torques"},
[408]={"query_commanded_joint_positions"},
[409]={"query_commanded_end_effector_pose"},
[410]={"query_commanded_joint_velocity"},
[411]={"query_commanded_end_effector_velocity_state"},
[412]={"query_commanded_actuator_force_torques"},
[413]={"query_end_effector_pose"},
[414]={"query_end_effector_velocity_state"},
[415]={"query_active_element"},
[416]={"query_pan_tilt_specifications",{"presence_vector",7}},
[417]={"query_pan_tilt_joint_effort"},
[418]={"query_pan_tilt_joint_positions"},
[419]={"query_pan_tilt_joint_velocity"},
[420]={"query_pan_tilt_motion_profile"},
[421]={"query_commanded_pan_tilt_joint_positions"},
[423]={"query_range_sensor_capabilities_rec",{"sensor_id",404},{"query_presence_vector",6}},
[422]={"query_range_sensor_capabilities",{"number_of_range_sensor_capabilities_list",6,counts=true},{"range_sensor_capabilities_list",406}},
[425]={"query_range_sensor_configuration_rec",{"sensor_id",404},{"query_presence_vector",6}},
[424]={"query_range_sensor_configuration",{"number_of_range_sensor_configuration_list",6,counts=true},{"range_sensor_configuration_list",408}},
[427]={"query_range_sensor_data_rec",{"sensor_id",404},{"report_coordinate_system",409},{"query_presence_vector",6}},
[426]={"query_range_sensor_data",{"number_of_query_range_sensor_data_list",6,counts=true},{"query_range_sensor_data_list",411}},
[429]={"query_range_sensor_compressed_data_rec",{"sensor_id",404},{"report_coordinate_system",409},{"data_compression",412},{"query_presence_vector",6}},
[428]={"query_range_sensor_compressed_data",{"number_of_query_range_sensor_compressed_data_list",6,counts=true},{"query_range_sensor_compressed_data_list",414}},
[431]={"sensor_id_query_rec",{"sensor_id",404}},
[430]={"query_sensor_geometric_properties",{"number_of_sensor_id_list",6,counts=true},{"sensor_id_list",416}},
[433]={"query_visual_sensor_capabilities_query_visual_sensor_capabilities_rec",{"sensor_id",404},{"query_presence_vector",6}},
[432]={"query_visual_sensor_capabilities",{"number_of_query_visual_sensor_capabilities_list",6,counts=true},{"query_visual_sensor_capabilities_list",418}},
[435]={"query_visual_sensor_configuration_rec",{"sensor_id",404},{"query_presence_vector",6}},
[434]={"query_visual_sensor_configuration",{"number_of_query_visual_sensor_configuration_list",6,counts=true},{"query_visual_sensor_configuration_list",420}},
[437]={"query_digital_video_configuration_rec",{"sensor_id",404},{"query_presence_vector",7}},
[436]={"query_digital_video_sensor_configuration",{"number_of_query_digital_video_configuration_list",6,counts=true},{"query_digital_video_configuration_list",422}},
[439]={"query_visual_sensor_capabilities_ext_query_visual_sensor_capabilities_rec",{"sensor_id",404},{"query_presence_vector",19}},
[438]={"query_visual_sensor_capabilities_ext",{"number_of_query_visual_sensor_capabilities_list",6,counts=true},{"query_visual_sensor_capabilities_list",424}},
[441]={"query_force_torque_capabilities_rec",{"sensor_id",6},{"query_presence_vector",6}},
[440]={"query_force_torque_capabilities",{"number_of_query_force_torque_capabilities_list",6,counts=true},{"query_force_torque_capabilities_list",426}},
[443]={"query_force_torque_rec",{"sensor_id",6},{"coordinate_system",427},{"query_presence_vector",7}},
[442]={"query_force_torque",{"number_of_query_force_torque_list",6,counts=true},{"query_force_torque_list",429}},
[444]={"query_analog_video_sensor_capabilities",{"number_of_sensor_id_list",6,counts=true},{"sensor_id_list",416}},
[445]={"query_analog_video_sensor_configuration",{"number_of_sensor_id_list",6,counts=true},{"sensor_id_list",416}},
[447]={"query_still_image_sensor_capabilities_rec",{"sensor_id",404},{"query_presence_vector",7}},
[446]={"query_still_image_sensor_capabilities",{"number_of_query_still_image_sensor_capabilities_list",6,counts=true},{"query_still_image_sensor_capabilities_list",431}},
[449]={"query_still_image_sensor_configuration_rec",{"sensor_id",404},{"query_presence_vector",7}},
[448]={"query_still_image_sensor_configuration",{"number_of_query_still_image_sensor_configuration_list",6,counts=true},{"query_still_image_sensor_configuration_list",433}},
[450]={"query_digital_resource_endpoint"},
[451]={"query_digital_audio_output_source",{"sensor_id",404}},
[452]={"query_digital_audio_output_capabilities",{"sensor_id",404}},
[454]={"illuminator_id_rec",{"illuminator_id",6}},
[453]={"query_video_illuminator_configuration",{"number_of_illuminator_id_list",6,counts=true},{"illuminator_id_list",435}},
[455]={"query_video_illuminator_capabilities",{"number_of_illuminator_id_list",6,counts=true},{"illuminator_id_list",435}},
[457]={"query_still_image_data_rec",{"sensor_id",404},{"report_coordinate_system",409},{"query_presence_vector",7}},
[456]={"query_still_image_data_ext",{"number_of_query_still_image_data_list",6,counts=true},{"query_still_image_data_list",437}},
[459]={"query_digital_video_sensor_capabilities_rec",{"sensor_id",404},{"query_presence_vector",7}},
[458]={"query_digital_video_sensor_capabilities_ext",{"number_of_query_digital_video_sensor_capabilities_list",6,counts=true},{"query_digital_video_sensor_capabilities_list",439}},
[460]={"query_digital_video_sensor_status",{"number_of_sensor_id_list",6,counts=true},{"sensor_id_list",416}},
[461]={"query_identification",{"query_type",440}},
[462]={"query_configuration",{"query_type",441}},
[463]={"query_subsystem_list"},
[466]={"query_services_node_rec",{"node_id",443}},
[467]={"query_services_component_rec",{"component_id",445}},
[465]={"query_services_node_seq",{"node_rec",444},{"number_of_component_list",442,counts=true},{"component_list",447}},
[464]={"query_services",{"number_of_node_list",442,counts=true},{"node_list",449}},
[470]={"query_service_list_subsystem_rec",{"subsystem_id",450}},
[472]={"query_service_list_node_rec",{"node_id",443}},
[473]={"query_service_list_component_rec",{"presence_vector",7,vector=1},{"component_id",445},{"search_filter_size",7,counts=true,bit=0},{"search_filter",100,bit=0}},
[471]={"query_service_list_node_seq",{"node_rec",452},{"number_of_component_list",442,counts=true},{"component_list",454}},
[469]={"query_service_list_subsystem_seq",{"subsystem_rec",451},{"number_of_node_list",442,counts=true},{"node_list",456}},
[468]={"query_service_list",{"number_of_subsystem_list",318,counts=true},{"subsystem_list",458}},
[474]={"report_authority",{"authority_code",7}},
[475]={"report_status",{"status",459},{"reserved",19}},
[476]={"report_timeout",{"timeout",460}},
[477]={"report_control",{"subsystem_id",6},{"node_id",7},{"component_id",7},{"authority_code",7}},
[479]={"report_event_rec",{"event_type",177},{"event_id",7},{"query_message_size",179,counts=true},{"query_message",180}},
[478]={"report_events",{"number_of_event_list",7,counts=true},{"event_list",462}},
[480]={"event",{"event_id",7},{"sequence_number",7},{"report_message_size",179,counts=true},{"report_message",180}},
[481]={"report_event_timeout",{"timeout",460}},
[482]={"command_event",{"event_id",7},{"command_result",463}},
[483]={"report_heartbeat_pulse"},
[484]={"report_global_pose",{"presence_vector",6,vector=9},{"latitude",184,bit=0},{"longitude",185,bit=1},{"altitude",186,bit=2},{"position_rms",187,bit=3},{"roll",188,bit=4},{"pitch",188,bit=5},{"yaw",188,bit=6},{"attitude_rms",189,bit=7},{"time_stamp",194,bit=8}},
[485]={"report_velocity_state",{"presence_vector",6,vector=9},{"velocity_x",464,bit=0},{"velocity_y",464,bit=1},{"velocity_z",464,bit=2},{"velocity_rms",465,bit=3},{"roll_rate",466,bit=4},{"pitch_rate",466,bit=5},{"yaw_rate",466,bit=6},{"rate_rms",467,bit=7},{"time_stamp",194,bit=8}},
[486]={"report_wrench_effort",{"presence_vector",6,vector=12},{"propulsive_linear_effort_x",195,bit=0},{"propulsive_linear_effort_y",195,bit=1},{"propulsive_linear_effort_z",195,bit=2},{"propulsive_rotational_effort_x",195,bit=3},{"propulsive_rotational_effort_y",195,bit=4},{"propulsive_rotational_effort_z",195,bit=5},{"resistive_linear_effort_x",196,bit=6},{"resistive_linear_effort_y",196,bit=7},{"resistive_linear_effort_z",196,bit=8},{"resistive_rotational_effort_x",196,bit=9},{"resistive_rotational_effort_y",196,bit=10},{"resistive_rotational_effort_z",196,bit=11}},
[487]={"report_global_vector",{"presence_vector",7,vector=5},{"speed",197,bit=0},{"altitude",186,bit=1},{"heading",188,bit=2},{"roll",188,bit=3},{"pitch",188,bit=4}},
[488]={"report_local_vector",{"presence_vector",7,vector=4},{"speed",197},{"z",186,bit=0},{"heading",188,bit=1},{"roll",188,bit=2},{"pitch",188,bit=3}},
[489]={"report_travel_speed",{"speed",197}},
[490]={"report_global_waypoint",{"presence_vector",7,vector=6},{"latitude",184},{"longitude",185},{"altitude",186,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"yaw",188,bit=3},{"waypoint_tolerance",198,bit=4},{"path_tolerance",199,bit=5}},
[491]={"report_local_waypoint",{"presence_vector",7,vector=6},{"x",200},{"y",200},{"z",200,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"yaw",188,bit=3},{"waypoint_tolerance",198,bit=4},{"path_tolerance",199,bit=5}},
[492]={"report_global_path_segment",{"presence_vector",7,vector=3},{"p1_latitude",184},{"p1_longitude",185},{"p1_altitude",186,bit=0},{"p2_latitude",184},{"p2_longitude",185},{"p2_altitude",186,bit=1},{"weighting_factor",60},{"path_tolerance",199,bit=2}},
[493]={"report_local_path_segment",{"presence_vector",7,vector=3},{"p1_x",200},{"p1_y",200},{"p1_z",186,bit=0},{"p2_x",200},{"p2_y",200},{"p2_z",186,bit=1},{"weighting_factor",60},{"path_tolerance",199,bit=2}},
[494]={"report_geomagnetic_property",{"magnetic_variation",188}},
[495]={"report_acceleration_state",{"presence_vector",6,vector=9},{"acceleration_x",468,bit=0},{"acceleration_y",468,bit=1},{"acceleration_z",468,bit=2},{"acceleration_rms",469,bit=3},{"roll_acceleration",470,bit=4},{"pitch_acceleration",470,bit=5},{"yaw_acceleration",470,bit=6},{"rotational_acceleration_rms",471,bit=7},{"time_stamp",194,bit=8}},
[496]={"report_element",{"element_uid",6},{"previous_uid",6},{"next_uid",6},{"element_data",203}},
[498]={"element_list_rec",{"element_uid",6}},
[497]={"report_element_list",{"number_of_element_list",6,counts=true},{"element_list",473}},
[499]={"report_element_count",{"element_count",6}},
[500]={"report_active_element",{"element_uid",6}},
[501]={"report_global_operating_zone",{"number_of_global_operating_zone",7,counts=true},{"global_operating_zone",218},{"number_of_global_exclusion_zones",7,counts=true},{"global_exclusion_zones",223}},
[503]={"excursion_rec",{"zone_id",209},{"zone_status",474}},
[502]={"report_excursion",{"number_of_excursion",7,counts=true},{"excursion",476}},
[504]={"report_global_loiter",{"global_loiter_rec",225},{"loiter",234}},
[505]={"report_local_loiter",{"local_loiter_rec",239},{"loiter",242}},
[506]={"report_local_operating_zone",{"number_of_local_operating_zone",7,counts=true},{"local_operating_zone",246},{"number_of_local_exclusion_zones",7,counts=true},{"local_exclusion_zones",251}},
[508]={"gps_fix_rec",{"presence_vector",7,vector=4},{"gps_fix_time_seconds",183},{"gps_fix_time_nano_seconds",19},{"gps_latitude",184,bit=0},{"gps_longitude",185,bit=1},{"gps_true_course",185,bit=2},{"gps_speed_over_ground",197,bit=3}},
[509]={"min_gps_rec",{"gps_validity",478},{"gps_magnetic_variation",184}},
[510]={"alt_gps_rec",{"presence_vector",7,vector=6},{"gps_status",480},{"gps_fix_command_status",481},{"gps_lat_lon_valid",482},{"gps_velocity_east",464,bit=0},{"gps_velocity_north",464,bit=1},{"gps_velocity_down",464,bit=2},{"gps_altitude",186,bit=3},{"number_of_satellites_seen",7,bit=4},{"number_of_satellites_in_solution",7,bit=5}},
[507]={"report_gps_fix",{"presence_vector",7,vector=1},{"gps_fix_rec",477},{"gps_status_var",484,bit=0}},
[511]={"report_inertial_sensor_status",{"power_state",485},{"operating_state",486}},
[512]={"report_global_pose_ext",{"presence_vector",6,vector=15},{"latitude",184,bit=0},{"longitude",185,bit=1},{"altitude_agl",213,bit=2},{"altitude_msl",213,bit=3},{"altitude_asf",213,bit=4},{"depth",213,bit=5},{"xy_position_rms",187,bit=6},{"z_position_rms",187,bit=7},{"roll",188,bit=8},{"pitch",188,bit=9},{"heading",188,bit=10},{"attitude_rms",189,bit=11},{"course",188,bit=12},{"time_seconds",183,bit=13},{"time_nano_seconds",19,bit=14}},
[514]={"velocity_vehicle_xyz_rec",{"presence_vector",7,vector=3},{"velocity_x",464,bit=0},{"velocity_y",464,bit=1},{"velocity_z",464,bit=2}},
[515]={"velocity_local_xyz_rec",{"presence_vector",7,vector=3},{"velocity_x",464,bit=0},{"velocity_y",464,bit=1},{"velocity_z",464,bit=2}},
[516]={"velocity_ned_rec",{"presence_vector",7,vector=3},{"velocity_n",464,bit=0},{"velocity_e",464,bit=1},{"velocity_d",464,bit=2}},
[517]={"report_velocity_state_ext_rec",{"presence_vector",6,vector=11},{"velocity_rms",465,bit=0},{"roll_rate",491,bit=1},{"pitch_rate",491,bit=2},{"yaw_rate",491,bit=3},{"rate_rms",492,bit=4},{"speed_over_ground",255,bit=5},{"speed_relative_to_medium",255,bit=6},{"rotations_per_minute",256,bit=7},{"indicated_speed",255,bit=8},{"time_seconds",183,bit=9},{"time_nano_seconds",19,bit=10}},
[513]={"report_velocity_state_ext",{"velocity_var",490},{"report_velocity_state_ext_rec",493}},
[518]={"report_global_vector_ext",{"presence_vector",7,vector=5},{"speed",258},{"z_position",259,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"heading",188,bit=3},{"course",188,bit=4}},
[519]={"report_local_vector_ext",{"presence_vector",7,vector=5},{"speed",258},{"z_position",260,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"heading",188,bit=3},{"course",188,bit=4}},
[520]={"report_travel_speed_ext",{"speed",258}},
[522]={"shared_z_position",{"index",212},{"value",214,tag={522,"index"}}},
[521]={"report_global_waypoint_ext",{"presence_vector",7,vector=6},{"latitude",184},{"longitude",185},{"z_position",494,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"heading",188,bit=3},{"waypoint_tolerance",262,bit=4},{"path_tolerance",199,bit=5}},
[523]={"report_local_waypoint_ext",{"presence_vector",7,vector=6},{"x",235},{"y",235},{"z_position",263,bit=0},{"roll",188,bit=1},{"pitch",188,bit=2},{"heading",188,bit=3},{"waypoint_tolerance",262,bit=4},{"path_tolerance",199,bit=5}},
[525]={"global_path_segment_driver_p1_z_position",{"index",212},{"value",214,tag={525,"index"}}},
[526]={"p_z_position",{"index",212},{"value",214,tag={526,"index"}}},
[524]={"report_global_path_segment_ext",{"presence_vector",7,vector=3},{"p1_latitude",184},{"p1_longitude",185},{"p1_z_position",495,bit=0},{"p2_latitude",184},{"p2_longitude",185},{"p_z_position",496,bit=1},{"weighting_factor",60},{"path_tolerance",199,bit=2}},
[528]={"local_path_segment_driver_p1_z_position",{"index",236},{"value",237,tag={528,"index"}}},
[529]={"p2_z_position",{"index",236},{"value",237,tag={529,"index"}}},
[527]={"report_local_path_segment_ext",{"presence_vector",7,vector=3},{"p1_x",235},{"p1_y",235},{"p1_z_position",497,bit=0},{"p2_x",235},{"p2_y",235},{"p2_z_position",498,bit=1},{"weighting_factor",60},{"path_tolerance",199,bit=2}},
[530]={"report_acceleration_state_ext",{"presence_vector",6,vector=10},{"acceleration_x",468,bit=0},{"acceleration_y",468,bit=1},{"acceleration_z",468,bit=2},{"acceleration_rms",469,bit=3},{"roll_acceleration",470,bit=4},{"pitch_acceleration",470,bit=5},{"yaw_acceleration",470,bit=6},{"rotational_acceleration_rms",499,bit=7},{"time_seconds",183,bit=8},{"time_nano_seconds",19,bit=9}},
[531]={"report_ackermann_configuration",{"presence_vector",7,vector=2},{"steering_angle",264},{"throttle_effort",265},{"brake_effort",265},{"steering_rate",500,bit=0},{"steering_torque",501,bit=1}},
[532]={"report_skid_steer_effort",{"left_side_propulsive_effort",268},{"right_side_propulsive_effort",268}},
[534]={"skidsteer",{"presence_vector",7,vector=2},{"track_separation",502,bit=0},{"drive_wheel_radius",503,bit=1}},
[535]={"ackermann",{"presence_vector",7,vector=4},{"steering_angle_range",264,bit=0},{"min_turn_radius",505,bit=1},{"wheel_separation",502,bit=2},{"drive_wheel_radius",503,bit=3}},
[536]={"platform_inertial",{"presence_vector",7,vector=7},{"maximum_forward_speed",508,bit=0},{"maximum_reverse_speed",508,bit=1},{"maximum_rotational_speed",509,bit=2},{"maximum_forward_acceleration",510,bit=3},{"maximum_reverse_acceleration",510,bit=4},{"maximum_forward_deceleration",510,bit=5},{"maximum_reverse_deceleration",510,bit=6}},
[537]={"platform_spec",{"presence_vector",6,vector=16},{"mobility_platform_name_size",7,counts=true},{"mobility_platform_name",100},{"front",502,bit=0},{"back",502,bit=1},{"right",502,bit=2},{"left",502,bit=3},{"bottom",502,bit=4},{"top",502,bit=5},{"xcg",512,bit=6},{"ycg",512,bit=7},{"zcg",512,bit=8},{"wheel_base",513,bit=9},{"static_pitch_over",188,bit=10},{"static_roll_over",188,bit=11},{"vehicle_weight",514,bit=12},{"approach_angle",515,bit=13},{"departure_angle",515,bit=14},{"break_over_angle",515,bit=15}},
[533]={"report_platform_specifications",{"platform_specifics",507},{"platform_inertial",511},{"platform_spec",516}},
[538]={"report_stabilizer_effort",{"number_of_stabilizer_effort",7,counts=true},{"stabilizer_effort",270}},
[540]={"report_stabilizer_position_stabilizer_position_rec",{"stabilizer_id",7},{"commanded_position",271},{"actual_position",271}},
[539]={"report_stabilizer_position",{"number_of_stabilizer_position",7,counts=true},{"stabilizer_position",518}},
[543]={"stabilizer_capabilities_rec",{"stabilizer_id",7},{"maximum_up_angle",519},{"maximum_down_angle",520}},
[544]={"points",{"point_x",522},{"point_y",522},{"point_z",522}},
[542]={"stabilizer_capabilities_seq",{"stabilizer_capabilities_rec",521},{"number_of_stabilizer_dimensions_list",7,counts=true},{"stabilizer_dimensions_list",524}},
[541]={"report_stabilizer_capabilities",{"number_of_stabilizer_capabilities",7,counts=true},{"stabilizer_capabilities",526}},
[545]={"report_power_plant_configuration",{"number_of_power_plant_configuration_list",7,counts=true},{"power_plant_configuration_list",284}},
[548]={"power_plant_desc_rec",{"power_plant_id",7},{"description_size",7,counts=true},{"description",100}},
[549]={"gas_engine_capabilities_rec",{"presence_vector",7,vector=7},{"fuel_capacity",528,bit=0},{"oil_capacity",528,bit=1},{"max_oil_pressure",529,bit=2},{"max_oil_temp",530,bit=3},{"max_engine_temp",531,bit=4},{"max_coolant_level",528,bit=5},{"max_coolant_temp",530,bit=6}},
[550]={"diesel_engine_capabilities_rec",{"presence_vector",6,vector=9},{"fuel_capacity",528,bit=0},{"oil_capacity",528,bit=1},{"max_oil_pressure",529,bit=2},{"max_oil_temp",530,bit=3},{"max_engine_temp",531,bit=4},{"max_coolant_level",528,bit=5},{"max_coolant_temp",530,bit=6},{"max_glow_plug_temp",531,bit=7},{"glow_plug_time",533,bit=8}},
[552]={"battery_capabilities_rec",{"presence_vector",7,vector=3},{"nominal_voltage",535,bit=0},{"max_charge",536,bit=1},{"max_cranking_amps",537,bit=2}},
[551]={"battery_capabilities_list",{"number_of_elements",7,counts=true},{"elements",539}},
[553]={"hydraulic_capabilities_rec",{"presence_vector",7,vector=3},{"fluid_capacity",528,bit=0},{"max_pressure",529,bit=1},{"max_temp",530,bit=2}},
[554]={"fuel_cell_capabilities_rec",{"presence_vector",7,vector=1},{"fuel_capacity",542,bit=0}},
[547]={"power_plant_capabilities_seq",{"power_plant_desc_rec",527},{"power_plant_capabilities_var",544}},
[546]={"report_power_plant_capabilities",{"number_of_power_plant_capabilities_list",7,counts=true},{"power_plant_capabilities_list",546}},
[557]={"gas_engine_status",{"presence_vector",6,vector=12},{"percent_remaining_fuel",265,bit=0},{"percent_oil_pressure",547,bit=1},{"percent_oil_level",265,bit=2},{"oil_temp",530,bit=3},{"engine_temp",530,bit=4},{"engine_hours",548,bit=5},{"tachometer",6,bit=6},{"coolant_level",528,bit=7},{"coolant_temp",530,bit=8},{"air_intake_pressure",529,bit=9},{"air_intake_temp",530,bit=10},{"exhaust_temp",530,bit=11}},
[558]={"diesel_engine_status",{"presence_vector",6,vector=13},{"percent_remaining_fuel",285,bit=0},{"percent_oil_pressure",550,bit=1},{"percent_oil_level",265,bit=2},{"oil_temp",530,bit=3},{"engine_temp",530,bit=4},{"engine_hours",548,bit=5},{"tachometer",6,bit=6},{"coolant_level",528,bit=7},{"coolant_temp",530,bit=8},{"air_intake_pressure",529,bit=9},{"air_intake_temp",530,bit=10},{"exhaust_temp",530,bit=11},{"glow_plug_temp",530,bit=12}},
[560]={"battery_status_rec",{"presence_vector",7,vector=5},{"percent_charge_remaining",265,bit=0},{"voltage",535,bit=1},{"current_draw",552,bit=2},{"battery_temp",530,bit=3},{"battery_hours",548,bit=4}},
[559]={"battery_status",{"number_of_elements",7,counts=true},{"elements",554}},
[561]={"hydraulic_status",{"presence_vector",7,vector=4},{"fluid_level",528,bit=0},{"percent_fluid_pressure",547,bit=1},{"fluid_temp",530,bit=2},{"total_hours",548,bit=3}},
[562]={"fuel_cell_status",{"presence_vector",7,vector=2},{"percent_remaining_fuel",265,bit=0},{"total_hours",548,bit=1}},
[556]={"power_plant_status",{"power_plant_desc_rec",527},{"power_plant_status_var",558}},
[555]={"report_power_plant_status",{"number_of_power_plant_status_list",7,counts=true},{"power_plant_status_list",560}},
[563]={"report_parking_brake",{"commanded_parking_brake",285},{"actual_parking_brake",285}},
[564]={"report_illumination_state",{"illumination",287}},
[566]={"types",{"headlights",561,first=0,carrier=32},{"left_turn_signal",561,first=1,carrier=32},{"right_turn_signal",561,first=2,carrier=32},{"running_lights",561,first=3,carrier=32},{"brake_lights",561,first=4,carrier=32},{"backup_lights",561,first=5,carrier=32},{"visible_light_source",561,first=6,carrier=32},{"ir_light_source",561,first=7,carrier=32},{"variable_light1",561,first=8,carrier=32},{"variable_light2",561,first=9,carrier=32},{"variable_light3",561,first=10,carrier=32},{"variable_light4",561,first=11,carrier=32},{"high_beams",561,first=12,carrier=32},{"parking_lights",561,first=13,carrier=32},{"fog_lights",561,first=14,carrier=32},{"hazard_lights",561,first=15,carrier=32,ends=true}},
[565]={"report_illumination_configuration",{"types",562}},
[567]={"report_odometry",{"odom",403},{"odometry",563}},
[569]={"manipulator_coordinate_system_rec",{"manipulator_coordinate_sys_x",305},{"manipulator_coordinate_sys_y",305},{"manipulator_coordinate_sys_z",305},{"d_component_of_unit_quaternion_q",69},{"a_component_of_unit_quaternion_q",69},{"b_component_of_unit_quaternion_q",69},{"c_component_of_unit_quaternion_q",69}},
[570]={"revolute_joint1_offset_rec",{"presence_vector",7,vector=5},{"joint1_offset",565},{"joint1_min_value",292,bit=0},{"joint1_max_value",292,bit=1},{"joint1_max_speed",315,bit=2},{"joint1_max_torque",566,bit=3},{"offset_bounding_cylinder_radius",503,bit=4}},
[571]={"prismatic_joint1_angle_rec",{"presence_vector",7,vector=3},{"joint1_angle",188},{"joint1_min_value",293},{"joint1_max_value",293},{"joint1_max_speed",300,bit=0},{"joint1_max_force",568,bit=1},{"joint_bounding_cylinder_radius",503,bit=2}},
[573]={"revolute_joint_specification_rec",{"presence_vector",7,vector=6},{"link_length",565},{"twist_angle",188},{"joint_offset",565},{"min_value",292,bit=0},{"max_value",292,bit=1},{"max_speed",315,bit=2},{"max_torque",566,bit=3},{"offset_bounding_cylinder_radius",503,bit=4},{"link_length_bounding_cylinder_radius",503,bit=5}},
[574]={"prismatic_joint_specification_rec",{"presence_vector",7,vector=4},{"link_length",565},{"twist_angle",188},{"joint_angle",188},{"min_value",293},{"max_value",293},{"max_speed",300,bit=0},{"max_force",568,bit=1},{"joint_bounding_cylinder_radius",503,bit=2},{"link_length_bounding_cylinder_radius",503,bit=3}},
[572]={"joint_specifications",{"value",573}},
[575]={"joint_name_rec",{"description_size",7,counts=true},{"description",100}},
[568]={"report_manipulator_specifications",{"presence_vector",7,vector=2},{"manipulator_coordinate_system_rec",564,bit=0},{"first_joint_parameters",570},{"number_of_joint_specification_list",7,counts=true},{"joint_specification_list",575},{"number_of_joint_names_list",7,counts=true,bit=1},{"joint_names_list",577,bit=1}},
[576]={"report_joint_effort",{"number_of_joint_effort_list",7,counts=true},{"joint_effort_list",290}},
[577]={"report_joint_velocity",{"number_of_joint_velocity_list",7,counts=true},{"joint_velocity_list",304}},
[578]={"report_joint_force_torques",{"number_of_actuator_force_torque_list",7,counts=true},{"actuator_force_torque_list",314}},
[579]={"report_commanded_joint_positions",{"number_of_joint_position_list",7,counts=true},{"joint_position_list",297}},
[580]={"report_commanded_end_effector_pose",{"tool_point_coordinate_x",305},{"tool_point_coordinate_y",305},{"tool_point_coordinate_z",305},{"d_component_of_unit_quaternion_q",69},{"a_component_of_unit_quaternion_q",69},{"b_component_of_unit_quaternion_q",69},{"c_component_of_unit_quaternion_q",69}},
[581]={"report_commanded_joint_velocity",{"number_of_joint_velocity_list",7,counts=true},{"joint_velocity_list",304}},
[582]={"report_commanded_end_effector_velocity_state",{"angular_velocity_component_x",306},{"angular_velocity_component_y",306},{"angular_velocity_component_z",306},{"linear_velocity_component_x",307},{"linear_velocity_component_y",307},{"linear_velocity_component_z",307}},
[583]={"report_commanded_actuator_force_torques",{"number_of_actuator_force_torque_list",7,counts=true},{"actuator_force_torque_list",314}},
[584]={"report_end_effector_pose",{"tool_point_coordinate_x",305},{"tool_point_coordinate_y",305},{"tool_point_coordinate_z",305},{"d_component_of_unit_quaternion_q",69},{"a_component_of_unit_quaternion_q",69},{"b_component_of_unit_quaternion_q",69},{"c_component_of_unit_quaternion_q",69}},
[585]={"report_end_effector_velocity_state",{"angular_velocity_component_x",306},{"angular_velocity_component_y",306},{"angular_velocity_component_z",306},{"linear_velocity_component_x",307},{"linear_velocity_component_y",307},{"linear_velocity_component_z",307}},
[586]={"report_active_element",{"element_uid",6}},
[587]={"report_pan_tilt_specifications",{"presence_vector",7,vector=7},{"pan_tilt_coordinate_sys_x",305,bit=0},{"pan_tilt_coordinate_sys_y",305,bit=1},{"pan_tilt_coordinate_sys_z",305,bit=2},{"d_component_of_unit_quaternion_q",69,bit=3},{"a_component_of_unit_quaternion_q",69,bit=4},{"b_component_of_unit_quaternion_q",69,bit=5},{"c_component_of_unit_quaternion_q",69,bit=6},{"joint1_min_value",292},{"joint1_max_value",292},{"joint1_max_speed",315},{"joint2_min_value",292},{"joint2_max_value",292},{"joint2_max_speed",315}},
[588]={"report_pan_tilt_joint_effort",{"joint1_effort",268},{"joint2_effort",268}},
[589]={"report_pan_tilt_joint_positions",{"joint1_position",292},{"joint2_position",292}},
[590]={"report_pan_tilt_joint_velocity",{"joint1_velocity",299},{"joint2_velocity",299}},
[591]={"report_pan_tilt_motion_profile",{"joint1_max_speed",315},{"joint1_max_acceleration_rate",316},{"joint1_max_deceleration_rate",316},{"joint2_max_speed",315},{"joint2_max_acceleration_rate",316},{"joint2_max_deceleration_rate",316}},
[592]={"report_commanded_pan_tilt_joint_positions",{"joint1_position",292},{"joint2_position",292}},
[595]={"supported_states",{"active",578,first=0,carrier=8},{"standby",578,first=1,carrier=8},{"off",578,first=2,carrier=8,ends=true}},
[596]={"supported_compression",{"no_compression",578,first=0,carrier=8},{"deflate",578,first=1,carrier=8},{"bzip2",578,first=2,carrier=8},{"lzma",578,first=3,carrier=8,ends=true}},
[594]={"range_sensor_capabilities_rec",{"presence_vector",6,vector=11},{"sensor_id",318},{"sensor_name_size",7,counts=true},{"sensor_name",100},{"supported_states",579,bit=0},{"minimum_horizontal_field_of_view_start_angle",342,bit=1},{"maximum_horizontal_field_of_view_stop_angle",342,bit=2},{"minimum_vertical_field_of_view_start_angle",342,bit=3},{"maximum_vertical_field_of_view_stop_angle",342,bit=4},{"miniumum_update_rate",343,bit=5},{"maximum_update_rate",343,bit=6},{"minimum_range",344,bit=7},{"maximum_range",344,bit=8},{"supported_compression",580,bit=9},{"coordinate_transformation_supported",482,bit=10}},
[593]={"report_range_sensor_capabilities",{"number_of_range_sensor_capabilities_list",6,counts=true},{"range_sensor_capabilities_list",582}},
[597]={"report_range_sensor_configuration",{"number_of_range_sensor_configuration_list",6,counts=true},{"range_sensor_configuration_list",347}},
[600]={"range_sensor_data_error_rec",{"sensor_id",318},{"data_error_code",583},{"error_message_size",7,counts=true},{"error_message",100}},
[603]={"time_stamp",{"milliseconds",190,first=0,carrier=32},{"seconds",191,first=10,carrier=32},{"minutes",191,first=16,carrier=32},{"hour",192,first=22,carrier=32},{"day",193,first=27,carrier=32,ends=true}},
[602]={"range_sensor_data_rec",{"sensor_id",318},{"report_coordinate_system",409},{"time_stamp",585}},
[604]={"range_sensor_data_point_rec",{"presence_vector",7,vector=7},{"point_id",19,bit=0},{"range",344},{"range_validity",482,bit=1},{"range_error_rms",199,bit=2},{"bearing",342},{"bearing_validity",482,bit=3},{"bearing_error_rms",587,bit=4},{"inclination",342},{"inclination_validity",482,bit=5},{"inclination_error_rms",587,bit=6}},
[601]={"range_sensor_data_seq",{"range_sensor_data_rec",586},{"number_of_range_sensor_data_point_list",6,counts=true},{"range_sensor_data_point_list",589}},
[599]={"range_sensor_data_variant",{"value",591}},
[598]={"report_range_sensor_data",{"number_of_range_sensor_data_list",6,counts=true},{"range_sensor_data_list",593}},
[607]={"range_sensor_compressed_data_rec",{"sensor_id",318},{"report_coordinate_system",409},{"time_stamp",585},{"data_compression",412},{"compressed_data_size",594,counts=true},{"compressed_data",39}},
[606]={"range_sensor_compressed_data_variant",{"value",596}},
[605]={"report_range_sensor_compressed_data",{"number_of_range_sensor_compressed_data_list",6,counts=true},{"range_sensor_compressed_data_list",598}},
[610]={"no_geometric_properties_variant",{"index",7,constant=0}},
[611]={"static_geometric_properties_rec",{"sensor_position",600},{"unit_quaternion",601}},
[612]={"manipulator_geometric_properties_rec",{"subsystem_id",6},{"node_id",7},{"component_id",7},{"joint_number",7},{"sensor_position",600},{"unit_quaternion",601}},
[609]={"geometric_properties_sequence",{"sensor_id_rec",319},{"geometric_properties_variant",604}},
[608]={"report_sensor_geometric_properties",{"number_of_geometric_properties_list",6,counts=true},{"geometric_properties_list",606}},
[615]={"zoom_modes",{"mixed",578,first=0,carrier=8},{"analog_only",578,first=1,carrier=8},{"digital_only",578,first=2,carrier=8},{"none",578,first=3,carrier=8,ends=true}},
[616]={"focus_modes",{"auto_focus",578,first=0,carrier=8},{"manual_focus",578,first=1,carrier=8,ends=true}},
[617]={"report_visual_sensor_capabilities_white_balance",{"auto",578,first=0,carrier=8},{"daylight",578,first=1,carrier=8},{"cloudy",578,first=2,carrier=8},{"shade",578,first=3,carrier=8},{"tungsten",578,first=4,carrier=8},{"flurescent",578,first=5,carrier=8},{"flash",578,first=6,carrier=8,ends=true}},
[618]={"report_visual_sensor_capabilities_imaging_modes",{"color",578,first=0,carrier=8},{"greyscale",578,first=1,carrier=8},{"infrared",578,first=2,carrier=8},{"lowlight",578,first=3,carrier=8},{"thermal_white_hot",578,first=4,carrier=8},{"thermal_black_hot",578,first=5,carrier=8},{"thermal_rainbow",578,first=6,carrier=8},{"reserved_for_future_use",610,first=7,carrier=8,ends=true}},
[619]={"exposure_modes",{"auto",578,first=0,carrier=8},{"manual",578,first=1,carrier=8},{"shutter_priority",578,first=2,carrier=8},{"aperture_priority",578,first=3,carrier=8,ends=true}},
[620]={"metering_modes",{"matrix_or_auto",578,first=0,carrier=8},{"center_weighted",578,first=1,carrier=8},{"spot",578,first=2,carrier=8,ends=true}},
[621]={"light_sensitivity_levels",{"auto",578,first=0,carrier=8},{"iso100",578,first=1,carrier=8},{"iso200",578,first=2,carrier=8},{"iso400",578,first=3,carrier=8},{"iso800",578,first=4,carrier=8},{"iso1600",578,first=5,carrier=8},{"iso3200",578,first=6,carrier=8,ends=true}},
[614]={"report_visual_sensor_capabilities_visual_sensor_capabilities_rec",{"presence_vector",6,vector=15},{"sensor_id",318},{"sensor_name_size",7,counts=true},{"sensor_name",100},{"supported_states",579,bit=0},{"zoom_modes",607,bit=1},{"focus_modes",608,bit=2},{"white_balance",609,bit=3},{"imaging_modes",611,bit=4},{"exposure_modes",612,bit=5},{"metering_modes",613,bit=6},{"minimum_shutter_speed",357,bit=7},{"maximum_shutter_speed",357,bit=8},{"minimum_aperture",358,bit=9},{"maximum_aperture",358,bit=10},{"minimum_focal_length",351,bit=11},{"maximum_focal_length",351,bit=12},{"light_sensitivity_levels",614,bit=13},{"image_stabilization",482,bit=14}},
[613]={"report_visual_sensor_capabilities",{"number_of_visual_sensor_capabilities_list",6,counts=true},{"visual_sensor_capabilities_list",616}},
[622]={"report_visual_sensor_configuration",{"number_of_visual_sensor_configuration_list",6,counts=true},{"visual_sensor_configuration_list",362}},
[623]={"report_digital_video_sensor_configuration",{"number_of_digital_video_sensor_configuration_list",6,counts=true},{"digital_video_sensor_configuration_list",367}},
[626]={"report_visual_sensor_capabilities_ext_white_balance",{"auto",578,first=0,carrier=8},{"daylight",578,first=1,carrier=8},{"cloudy",578,first=2,carrier=8},{"shade",578,first=3,carrier=8},{"tungsten",578,first=4,carrier=8},{"flurescent",578,first=5,carrier=8},{"flash",578,first=6,carrier=8,ends=true}},
[627]={"report_visual_sensor_capabilities_ext_imaging_modes",{"color",578,first=0,carrier=32},{"greyscale",578,first=1,carrier=32},{"infrared",578,first=2,carrier=32},{"lowlight",578,first=3,carrier=32},{"thermal_white_hot",578,first=4,carrier=32},{"thermal_black_hot",578,first=5,carrier=32},{"thermal_rainbow",578,first=6,carrier=32},{"reserved_for_future_use",618,first=7,carrier=32},{"reserved_for_program_specific_use",619,first=21,carrier=32,ends=true}},
[625]={"report_visual_sensor_capabilities_ext_visual_sensor_capabilities_rec",{"presence_vector",19,vector=19},{"sensor_id",318},{"sensor_name_size",7,counts=true},{"sensor_name",100},{"supported_states",579,bit=0},{"zoom_modes",607,bit=1},{"focus_modes",608,bit=2},{"white_balance",617,bit=3},{"imaging_modes",620,bit=4},{"exposure_modes",612,bit=5},{"metering_modes",613,bit=6},{"minimum_shutter_speed",357,bit=7},{"maximum_shutter_speed",357,bit=8},{"minimum_aperture",358,bit=9},{"maximum_aperture",358,bit=10},{"minimum_focal_length",351,bit=11},{"maximum_focal_length",351,bit=12},{"light_sensitivity_levels",614,bit=13},{"image_stabilization",482,bit=14},{"minimum_horizontal_field_of_view",342,bit=15},{"maximum_horizontal_field_of_view",342,bit=16},{"minimum_vertical_field_of_view",342,bit=17},{"maximum_vertical_field_of_view",342,bit=18}},
[624]={"report_visual_sensor_capabilities_ext",{"number_of_visual_sensor_capabilities_list",6,counts=true},{"visual_sensor_capabilities_list",622}},
[629]={"report_force_torque_capabilities_rec",{"presence_vector",6,vector=13},{"sensor_id",6},{"sensor_name_size",7,counts=true},{"sensor_name",100},{"coordinate_transform_supported",482,bit=0},{"min_force_x",623,bit=1},{"max_force_x",623,bit=2},{"min_force_y",623,bit=3},{"max_force_y",623,bit=4},{"min_force_z",623,bit=5},{"max_force_z",623,bit=6},{"min_torque_x",624,bit=7},{"max_torque_x",624,bit=8},{"min_torque_y",624,bit=9},{"max_torque_y",624,bit=10},{"min_torque_z",624,bit=11},{"max_torque_z",624,bit=12}},
[628]={"report_force_torque_capabilities",{"number_of_report_force_torque_capabilities_list",6,counts=true},{"report_force_torque_capabilities_list",626}},
[631]={"report_force_torque_rec",{"presence_vector",7,vector=6},{"sensor_id",6},{"coordinate_system",427},{"force_x",623,bit=0},{"force_y",623,bit=1},{"force_z",623,bit=2},{"torque_x",624,bit=3},{"torque_y",624,bit=4},{"torque_z",624,bit=5}},
[630]={"report_force_torque",{"number_of_report_force_torque_list",6,counts=true},{"report_force_torque_list",628}},
[634]={"supported_analog_formats",{"ntscm",578,first=0,carrier=8},{"ntscj",578,first=1,carrier=8},{"paln",578,first=2,carrier=8},{"palm",578,first=3,carrier=8},{"secaml",578,first=4,carrier=8},{"secambg",578,first=5,carrier=8,ends=true}},
[633]={"analog_video_sensor_capabilities_rec",{"sensor_id",318},{"supported_analog_formats",629}},
[632]={"report_analog_video_sensor_capabilities",{"number_of_analog_video_sensor_capabilities_list",6,counts=true},{"analog_video_sensor_capabilities_list",631}},
[635]={"report_analog_video_sensor_configuration",{"number_of_analog_video_sensor_configuration_list",6,counts=true},{"analog_video_sensor_configuration_list",372}},
[638]={"supported_frame_sizes",{"sqcif_128x96",578,first=0,carrier=32},{"qcif_176x144",578,first=1,carrier=32},{"cif_352x288",578,first=2,carrier=32},{"cif4_704x576",578,first=3,carrier=32},{"cif16_1408x1152",578,first=4,carrier=32},{"qqvga_160x120",578,first=5,carrier=32},{"qvga_320x240",578,first=6,carrier=32},{"vga_640x480",578,first=7,carrier=32},{"svga_800x600",578,first=8,carrier=32},{"xga_1024x768",578,first=9,carrier=32},{"uxga_1600x1200",578,first=10,carrier=32},{"qxga_2048x1536",578,first=11,carrier=32},{"sxga_1280x1024",578,first=12,carrier=32},{"qsxga_2560x2048",578,first=13,carrier=32},{"hsxga_5120x4096",578,first=14,carrier=32},{"wvga_852x480",578,first=15,carrier=32},{"wxga_1366x768",578,first=16,carrier=32},{"wsxga_1600x1024",578,first=17,carrier=32},{"wuxga_1920x1200",578,first=18,carrier=32},{"woxga_2560x1600",578,first=19,carrier=32},{"wqsxga_3200x2048",578,first=20,carrier=32},{"wquxga_3840x2400",578,first=21,carrier=32},{"whsxga_6400x4096",578,first=22,carrier=32},{"whuxga_7680x4800",578,first=23,carrier=32},{"cga_320x200",578,first=24,carrier=32},{"ega_640x350",578,first=25,carrier=32},{"hd480_852x480",578,first=26,carrier=32},{"hd720_1280x720",578,first=27,carrier=32},{"hd1080_1920x1080",578,first=28,carrier=32,ends=true}},
[639]={"supported_image_formats",{"jpeg",578,first=0,carrier=16},{"gif",578,first=1,carrier=16},{"png",578,first=2,carrier=16},{"bmp",578,first=3,carrier=16},{"tiff",578,first=4,carrier=16},{"ppm",578,first=5,carrier=16},{"pgm",578,first=6,carrier=16},{"pnm",578,first=7,carrier=16},{"nef_nikon_raw",578,first=8,carrier=16},{"cr2_canon_raw",578,first=9,carrier=16},{"dng_adobe_raw",578,first=10,carrier=16,ends=true}},
[637]={"still_image_sensor_capabilities_rec",{"presence_vector",7,vector=2},{"sensor_id",318},{"supported_frame_sizes",632,bit=0},{"supported_image_formats",633,bit=1}},
[636]={"report_still_image_sensor_capabilities",{"number_of_still_image_sensor_list",6,counts=true},{"still_image_sensor_list",635}},
[640]={"report_still_image_sensor_configuration",{"number_of_still_image_sensor_configuration_list",6,counts=true},{"still_image_sensor_configuration_list",376}},
[641]={"report_digital_resource_endpoint",{"number_of_digital_resource_endpoint_list",7,counts=true},{"digital_resource_endpoint_list",636}},
[642]={"report_digital_audio_output_source",{"number_of_digital_audio_output_source_list",6,counts=true},{"digital_audio_output_source_list",385}},
[645]={"digital_audio_output_supported_digital_formats",{"lpcm_pcm",561,first=0,carrier=32},{"aiff",561,first=1,carrier=32},{"wav",561,first=2,carrier=32},{"alac",561,first=3,carrier=32},{"flac",561,first=4,carrier=32},{"real_audio",561,first=5,carrier=32},{"wma9_lossless",561,first=6,carrier=32},{"true_audio",561,first=7,carrier=32},{"dolby_digital",561,first=8,carrier=32},{"dts",561,first=9,carrier=32},{"mp2",561,first=10,carrier=32},{"mp3",561,first=11,carrier=32},{"aac_mpeg2",561,first=12,carrier=32},{"aac_mpeg4",561,first=13,carrier=32},{"vorbis",561,first=14,carrier=32},{"wma",561,first=15,carrier=32},{"speex",561,first=16,carrier=32,ends=true}},
[646]={"supported_bit_depths",{"eight_bits",561,first=0,carrier=16},{"ten_bits",561,first=1,carrier=16},{"twelve_bits",561,first=2,carrier=16},{"fourteen_bits",561,first=3,carrier=16},{"sixteen_bits",561,first=4,carrier=16},{"twenty_bits",561,first=5,carrier=16},{"twenty_four_bits",561,first=6,carrier=16},{"thirty_two_bits",561,first=7,carrier=16,ends=true}},
[644]={"digital_audio_output_capabilities_rec",{"presence_vector",7,vector=6},{"sensor_id",318},{"minimum_allowed_bit_rate",6,bit=0},{"maximum_allowed_bit_rate",6,bit=1},{"supported_digital_formats",637,bit=2},{"min_sample_rate",19,bit=3},{"max_sample_rate",19,bit=4},{"supported_bit_depths",638,bit=5}},
[643]={"report_digital_audio_output_capabilities",{"number_of_digital_audio_output_capabilities_list",6,counts=true},{"digital_audio_output_capabilities_list",640}},
[647]={"report_video_illuminator_configuration",{"number_of_illumination_rec_list",6,counts=true},{"illumination_rec_list",390}},
[651]={"supported_illumination_modes",{"visible",561,first=0,carrier=32},{"infrared",561,first=1,carrier=32},{"grey_scale",561,first=2,carrier=32},{"low_light",561,first=3,carrier=32},{"reserved_for_future_use",641,first=4,carrier=32},{"reserved_for_program_or_implementation_specific_use",642,first=21,carrier=32,ends=true}},
[650]={"illuminator_capabilities_rec",{"presence_vector",7,vector=6},{"illuminator_id",6},{"illuminator_name_size",7,counts=true},{"illuminator_name",100},{"supported_illumination_modes",643},{"minimum_intensity",644,bit=0},{"maximum_intensity",644,bit=1},{"minimum_supported_beam_width",388,bit=2},{"maximum_supported_beam_width",388,bit=3},{"minimum_supported_beam_height",388,bit=4},{"maximum_supported_beam_height",388,bit=5}},
[652]={"video_illuminator_sensor_id_rec",{"sensor_id",6}},
[649]={"illuminator_capabilities_seq",{"illuminator_capabilities_rec",645},{"number_of_sensor_id_list",7,counts=true},{"sensor_id_list",647}},
[648]={"report_video_illuminator_capabilities",{"number_of_illuminator_capabilities_list",6,counts=true},{"illuminator_capabilities_list",649}},
[655]={"image_frame",{"format",374},{"data_size",594,counts=true},{"data",39}},
[654]={"still_image_data_rec",{"presence_vector",7,vector=3},{"sensor_id",318},{"report_coordinate_system",409},{"time_stamp",585,bit=0},{"image_frame",650,bit=1},{"still_image_uri_size",7,counts=true,bit=2},{"still_image_uri",100,bit=2}},
[653]={"report_still_image_data_ext",{"number_of_still_image_data_list",6,counts=true},{"still_image_data_list",652}},
[658]={"digital_video_supported_digital_formats",{"avi",578,first=0,carrier=8},{"mjpeg",578,first=1,carrier=8},{"mpeg2",578,first=2,carrier=8},{"h263",578,first=3,carrier=8},{"h263plus",578,first=4,carrier=8},{"mpeg4_visual",578,first=5,carrier=8},{"mpeg4_avc_h264",578,first=6,carrier=8,ends=true}},
[657]={"digital_video_sensor_capabilities_rec",{"presence_vector",7,vector=7},{"sensor_id",318},{"minimum_bit_rate",6,bit=0},{"maximum_bit_rate",6,bit=1},{"minimum_frame_rate",7,bit=2},{"maximum_frame_rate",7,bit=3},{"supported_frame_sizes",632,bit=4},{"supported_digital_formats",653,bit=5},{"recording_supported",654,bit=6}},
[656]={"report_digital_video_sensor_capabilities_ext",{"number_of_digital_video_sensor_list",6,counts=true},{"digital_video_sensor_list",656}},
[660]={"digital_video_sensor_status_rec",{"sensor_id",318},{"streaming_state",368},{"recording_state",381}},
[659]={"report_digital_video_sensor_status",{"number_of_digital_video_sensor_status_list",6,counts=true},{"digital_video_sensor_status_list",658}},
[661]={"report_identification",{"query_type",440},{"type",659},{"identification_size",7,counts=true},{"identification",100}},
[664]={"report_configuration_node_rec",{"node_id",7}},
[665]={"report_configuration_component_rec",{"component_id",7},{"instance_id",7}},
[663]={"report_configuration_node_seq",{"node_rec",660},{"number_of_component_list",7,counts=true},{"component_list",662}},
[662]={"report_configuration",{"number_of_node_list",7,counts=true},{"node_list",664}},
[667]={"report_subsystem_list_subsystem_rec",{"subsystem_id",6},{"node_id",7},{"component_id",7}},
[666]={"report_subsystem_list",{"number_of_subsystem_list",7,counts=true},{"subsystem_list",666}},
[670]={"report_services_node_rec",{"node_id",7}},
[672]={"report_services_component_rec",{"component_id",7},{"instance_id",7}},
[671]={"component_seq",{"component_rec",668},{"number_of_service_list",7,counts=true},{"service_list",392}},
[669]={"report_services_node_seq",{"node_rec",667},{"number_of_component_list",7,counts=true},{"component_list",670}},
[668]={"report_services",{"number_of_node_list",7,counts=true},{"node_list",672}},
[675]={"report_service_list_subsystem_rec",{"subsystem_id",6}},
[677]={"report_service_list_node_rec",{"node_id",7}},
[676]={"report_service_list_node_seq",{"node_rec",674},{"number_of_component_list",7,counts=true},{"component_list",670}},
[674]={"report_service_list_subsystem_seq",{"subsystem_rec",673},{"number_of_node_list",7,counts=true},{"node_list",676}},
[673]={"report_service_list",{"number_of_subsystem_list",6,counts=true},{"subsystem_list",678}},
[678]={"set_local_vector",{"presence_vector",7,vector=5},{"speed",197,bit=0},{"z",186,bit=1},{"heading",188,bit=2},{"roll",188,bit=3},{"pitch",188,bit=4}},
[679]={"report_local_vector",{"presence_vector",7,vector=5},{"speed",197,bit=0},{"z",186,bit=1},{"heading",188,bit=2},{"roll",188,bit=3},{"pitch",188,bit=4}},
}
-- Messages: name, title, structure.
local ra_messages = {
[0x0001]={"set_component_authority","Set Component Authority",5},
[0x0002]={"shutdown","Shutdown",6},
[0x0003]={"standby","Standby",7},
[0x0004]={"resume","Resume",8},
[0x0005]={"reset","Reset",9},
[0x0006]={"set_emergency","Set Emergency",10},
[0x0007]={"clear_emergency","Clear Emergency",11},
[0x0008]={"create_service_connection","Create Service Connection",12},
[0x0009]={"confirm_service_connection","Confirm Service Connection",13},
[0x000A]={"activate_service_connection","Activate Service Connection",14},
[0x000B]={"suspend_service_connection","Suspend Service Connection",15},
[0x000C]={"terminate_service_connection","Terminate Service Connection",16},
[0x000D]={"request_component_control","Request Component Control",17},
[0x000E]={"release_component_control","Release Component Control",18},
[0x000F]={"confirm_component_control","Confirm Component Control",19},
[0x0010]={"reject_component_control","Reject Component Control",20},
[0x0011]={"set_time","Set Time",21},
[0x01F0]={"create_event","Create Event",24},
[0x01F1]={"update_event","Update Event",27},
[0x01F2]={"cancel_event","Cancel Event",28},
[0x01F3]={"confirm_event_request","Confirm Event Request",29},
[0x01F4]={"reject_event_request","Reject Event Request",30},
[0x0200]={"set_data_link_state","Set Data Link State",31},
[0x0201]={"set_data_link_select","Set Data Link Select",32},
[0x0202]={"set_selected_data_link_state","Set Selected Data Link State",33},
[0x0404]={"set_velocity_state","Set Velocity State",34},
[0x0405]={"set_wrench_effort","Set Wrench Effort",35},
[0x0406]={"set_discrete_devices","Set Discrete Devices",36},
[0x0407]={"set_global_vector","Set Global Vector",37},
[0x0408]={"set_local_vector","Set Local Vector",38},
[0x040A]={"set_travel_speed","Set Travel Speed",39},
[0x040C]={"set_global_waypoint","Set Global Waypoint",40},
[0x040D]={"set_local_waypoint","Set Local Waypoint",41},
[0x040F]={"set_global_path_segment","Set Global Path Segment",42},
[0x0410]={"set_local_path_segment","Set Local Path Segment",43},
[0x0601]={"set_joint_efforts","Set Joint Efforts",44},
[0x0602]={"set_joint_positions","Set Joint Positions",45},
[0x0603]={"set_joint_velocities","Set Joint Velocities",46},
[0x0604]={"set_tool_point","Set Tool Point",47},
[0x0605]={"set_end_effector_pose","Set End-Effector Pose",48},
[0x0606]={"set_end_effector_velocity_state","Set End-Effector Velocity State",49},
[0x0607]={"set_joint_motion","Set Joint Motion",50},
[0x0608]={"set_end_effector_path_motion","Set End-Effector Path Motion",53},
[0x0801]={"set_camera_pose","Set Camera Pose",55},
[0x0802]={"select_camera","Select Camera",56},
[0x0805]={"set_camera_capabilities","Set Camera Capabilities",57},
[0x0806]={"set_camera_format_options","Set Camera Format Options",58},
[0x0A20]={"create_vector_knowledge_store_objects","Create Vector Knowledge Store Objects",59},
[0x0A21]={"set_vector_knowledge_store_feature_class_metadata","Set Vector Knowledge Store Feature Class Metadata",63},
[0x0A24]={"terminate_vector_knowledge_store_data_transfer","Terminate Vector Knowledge Store Data Transfer",64},
[0x0A25]={"delete_vector_knowledge_store_objects","Delete Vector Knowledge Store Objects",65},
[0x0D01]={"set_payload_data_element","Set Payload Data Element",67},
[0x0E00]={"spool_mission","Spool Mission",68},
[0x0E01]={"run_mission","Run Mission",72},
[0x0E02]={"abort_mission","Abort Mission",73},
[0x0E03]={"pause_mission","Pause Mission",74},
[0x0E04]={"resume_mission","Resume Mission",75},
[0x0E05]={"remove_messages","Remove Messages",76},
[0x0E06]={"replace_messages","Replace Messages",77},
[0x2001]={"query_component_authority","Query Component Authority",78,report=0x4001},
[0x2002]={"query_component_status","Query Component Status",79,report=0x4002},
[0x200D]={"query_component_control","Query Component Control",80,report=0x400D},
[0x2011]={"query_time","Query Time",81,report=0x4011},
[0x21F0]={"query_events","Query Events",82,report=0x41F0},
[0x2200]={"query_data_link_status","Query Data Link Status",83,report=0x4200},
[0x2201]={"query_selected_data_link_status","Query Selected Data Link Status",84,report=0x4201},
[0x2202]={"query_heartbeat_pulse","Query Heartbeat Pulse",85,report=0x4202},
[0x2400]={"query_platform_specifications","Query Platform Specifications",86,report=0x4400},
[0x2401]={"query_platform_operational_data","Query Platform Operational Data",87,report=0x4401},
[0x2402]={"query_global_pose","Query Global Pose",88,report=0x4402},
[0x2403]={"query_local_pose","Query Local Pose",89,report=0x4403},
[0x2404]={"query_velocity_state","Query Velocity State",90,report=0x4404},
[0x2405]={"query_wrench_effort","Query Wrench Effort",91,report=0x4405},
[0x2406]={"query_discrete_devices","Query Discrete Devices",92,report=0x4406},
[0x2407]={"query_global_vector","Query Global Vector",93,report=0x4407},
[0x2408]={"query_local_vector","Query Local Vector",94,report=0x4408},
[0x240A]={"query_travel_speed","Query Travel Speed",95,report=0x440A},
[0x240B]={"query_waypoint_count","Query Waypoint Count",96,report=0x440B},
[0x240C]={"query_global_waypoint","Query Global Waypoint",97,report=0x440C},
[0x240D]={"query_local_waypoint","Query Local Waypoint",98,report=0x440D},
[0x240E]={"query_path_segment_count","Query Path Segment Count",99,report=0x440E},
[0x240F]={"query_global_path_segment","Query Global Path Segment",100,report=0x440F},
[0x2410]={"query_local_path_segment","Query Local Path Segment",101,report=0x4410},
[0x2600]={"query_manipulator_specifications","Query Manipulator Specifications",102,report=0x4600},
[0x2601]={"query_joint_efforts","Query Joint Efforts",103,report=0x4601},
[0x2602]={"query_joint_positions","Query Joint Positions",104,report=0x4602},
[0x2603]={"query_joint_velocities","Query Joint Velocities",105,report=0x4603},
[0x2604]={"query_tool_point","Query Tool Point",106,report=0x4604},
[0x2605]={"query_joint_force_torques","Query Joint Force/Torques",107,report=0x4605},
[0x2800]={"query_camera_pose","Query Camera Pose",108,report=0x4800},
[0x2801]={"query_camera_count","Query Camera Count",109,report=0x4801},
[0x2802]={"query_relative_object_position","Query Relative Object Position",110,report=0x4802},
[0x2804]={"query_selected_camera","Query Selected Camera",111,report=0x4804},
[0x2805]={"query_camera_capabilities","Query Camera Capabilities",112,report=0x4805},
[0x2806]={"query_camera_format_options","Query Camera Format Options",113,report=0x4806},
[0x2807]={"query_image","Query Image",114,report=0x4807},
[0x2A21]={"query_vector_knowledge_store_feature_class_metadata","Query Vector Knowledge Store Feature Class Metadata",115,report=0x4A21},
[0x2A22]={"query_vector_knowledge_store_bounds","Query Vector Knowledge Store Bounds",116,report=0x4A22},
[0x2A23]={"query_vector_knowledge_store_objects","Query Vector Knowledge Store Objects",117,report=0x4A23},
[0x2B00]={"query_identification","Query Identification",119,report=0x4B00},
[0x2B01]={"query_configuration","Query Configuration",120,report=0x4B01},
[0x2B02]={"query_subsystem_list","Query Subsystem List",121,report=0x4B02},
[0x2B03]={"query_services","Query Services",122,report=0x4B03},
[0x2D00]={"query_payload_interface","Query Payload Interface",123,report=0x4D00},
[0x2D01]={"query_payload_data_element","Query Payload Data Element",124,report=0x4D01},
[0x2E00]={"query_spooling_preference","Query Spooling Preference",125,report=0x4E00},
[0x2E01]={"query_mission_status","Query Mission Status",126,report=0x4E01},
[0x4001]={"report_component_authority","Report Component Authority",127,query=0x2001},
[0x4002]={"report_component_status","Report Component Status",128,query=0x2002},
[0x400D]={"report_component_control","Report Component Control",129,query=0x200D},
[0x4011]={"report_time","Report Time",130,query=0x2011},
[0x41F0]={"report_events","Report Events",131,query=0x21F0},
[0x41F1]={"event","Event",133},
[0x4200]={"report_data_link_status","Report Data Link Status",134,query=0x2200},
[0x4201]={"report_selected_data_link_status","Report Selected Data Link Status",135,query=0x2201},
[0x4202]={"report_heartbeat_pulse","Report Heartbeat Pulse",136,query=0x2202},
[0x4400]={"report_platform_specifications","Report Platform Specifications",137,query=0x2400},
[0x4401]={"report_platform_operational_data","Report Platform Operational Data",138,query=0x2401},
[0x4402]={"report_global_pose","Report Global Pose",139,query=0x2402},
[0x4403]={"report_local_pose","Report Local Pose",140,query=0x2403},
[0x4404]={"report_velocity_state","Report Velocity State",141,query=0x2404},
[0x4405]={"report_wrench_effort","Report Wrench Effort",142,query=0x2405},
[0x4406]={"report_discrete_devices","Report Discrete Devices",143,query=0x2406},
[0x4407]={"report_global_vector","Report Global Vector",144,query=0x2407},
[0x4408]={"report_local_vector","Report Local Vector",145,query=0x2408},
[0x440A]={"report_travel_speed","Report Travel Speed",146,query=0x240A},
[0x440B]={"report_waypoint_count","Report Waypoint Count",147,query=0x240B},
[0x440C]={"report_global_waypoint","Report Global Waypoint",148,query=0x240C},
[0x440D]={"report_local_waypoint","Report Local Waypoint",149,query=0x240D},
[0x440E]={"report_path_segment_count","Report Path Segment Count",150,query=0x240E},
[0x440F]={"report_global_path_segment","Report Global Path Segment",151,query=0x240F},
[0x4410]={"report_local_path_segment","Report Local Path Segment",152,query=0x2410},
[0x4600]={"report_manipulator_specifications","Report Manipulator Specifications",153,query=0x2600},
[0x4601]={"report_joint_efforts","Report Joint Efforts",155,query=0x2601},
[0x4602]={"report_joint_positions","Report Joint Positions",156,query=0x2602},
[0x4603]={"report_joint_velocities","Report Joint Velocities",157,query=0x2603},
[0x4604]={"report_tool_point","Report Tool Point",158,query=0x2604},
[0x4605]={"report_joint_force_torques","Report Joint Force/Torques",159,query=0x2605},
[0x4800]={"report_camera_pose","Report Camera Pose",160,query=0x2800},
[0x4801]={"report_camera_count","Report Camera Count",161,query=0x2801},
[0x4802]={"report_relative_object_position","Report Relative Object Position",162,query=0x2802},
[0x4804]={"report_selected_camera","Report Selected Camera",163,query=0x2804},
[0x4805]={"report_camera_capabilities","Report Camera Capabilities",164,query=0x2805},
[0x4806]={"report_camera_format_options","Report Camera Format Options",165,query=0x2806},
[0x4807]={"report_image","Report Image",166,query=0x2807},
[0x4A20]={"report_vector_knowledge_store_objects_creation","Report Vector Knowledge Store Objects Creation",167},
[0x4A21]={"report_vector_knowledge_store_feature_class_metadata","Report Vector Knowledge Store Feature Class Metadata",168,query=0x2A21},
[0x4A22]={"report_vector_knowledge_store_bounds","Report Vector Knowledge Store Bounds",169,query=0x2A22},
[0x4A23]={"report_vector_knowledge_store_objects","Report Vector Knowledge Store Objects",170,query=0x2A23},
[0x4A24]={"report_vector_knowledge_store_data_transfer_termination","Report Vector Knowledge Store Data Transfer Termination",172},
[0x4B00]={"report_identification","Report Identification",173,query=0x2B00},
[0x4B01]={"report_configuration","Report Configuration",174,query=0x2B01},
[0x4B02]={"report_subsystem_list","Report Subsystem List",177,query=0x2B02},
[0x4B03]={"report_services","Report Services",179,query=0x2B03},
[0x4D00]={"report_payload_interface","Report Payload Interface",182,query=0x2D00},
[0x4D01]={"report_payload_data_element","Report Payload Data Element",188,query=0x2D01},
[0x4E00]={"report_spooling_preference","Report Spooling Preference",189,query=0x2E00},
[0x4E01]={"report_mission_status","Report Mission Status",190,query=0x2E01},
}
local sae_messages = {
[0x0001]={"set_authority","SetAuthority",191},
[0x0002]={"shutdown","Shutdown",192},
[0x0003]={"standby","Standby",193},
[0x0004]={"resume","Resume",194},
[0x0005]={"reset","Reset",195},
[0x0006]={"set_emergency","SetEmergency",196},
[0x0007]={"clear_emergency","ClearEmergency",197},
[0x000D]={"request_control","RequestControl",198},
[0x000E]={"release_control","ReleaseControl",199},
[0x000F]={"confirm_control","ConfirmControl",200},
[0x0010]={"reject_control","RejectControl",201},
[0x01F0]={"create_event","CreateEvent",202},
[0x01F1]={"update_event","UpdateEvent",203},
[0x01F2]={"cancel_event","CancelEvent",204},
[0x01F3]={"confirm_event_request","ConfirmEventRequest",205},
[0x01F4]={"reject_event_request","RejectEventRequest",206},
[0x01F6]={"create_command_event","CreateCommandEvent",207},
[0x0402]={"set_global_pose","SetGlobalPose",208},
[0x0405]={"set_wrench_effort","SetWrenchEffort",210},
[0x0407]={"set_global_vector","SetGlobalVector",211},
[0x0408]={"set_local_vector","SetLocalVector",212},
[0x040A]={"set_travel_speed","SetTravelSpeed",213},
[0x040C]={"set_global_waypoint","SetGlobalWaypoint",214},
[0x040D]={"set_local_waypoint","SetLocalWaypoint",215},
[0x0412]={"set_geomagnetic_property","SetGeomagneticProperty",216},
[0x041A]={"set_element","SetElement",217},
[0x041B]={"delete_element","DeleteElement",221},
[0x041C]={"confirm_element_request","ConfirmElementRequest",223},
[0x041D]={"reject_element_request","RejectElementRequest",224},
[0x041E]={"execute_list","ExecuteList",225},
[0x0422]={"delete_zone","DeleteZone",226},
[0x0423]={"set_global_operating_zone","SetGlobalOperatingZone",228},
[0x0425]={"set_global_loiter","SetGlobalLoiter",235},
[0x0426]={"set_local_loiter","SetLocalLoiter",241},
[0x0427]={"set_local_operating_zone","SetLocalOperatingZone",245},
[0x0428]={"request_gps_fix","RequestGPSFix",252},
[0x0429]={"inertial_sensor_control","InertialSensorControl",253},
[0x04A2]={"set_global_pose_ext","SetGlobalPoseExt",254},
[0x04A7]={"set_global_vector_ext","SetGlobalVectorExt",256},
[0x04A8]={"set_local_vector_ext","SetLocalVectorExt",259},
[0x04AA]={"set_travel_speed_ext","SetTravelSpeedExt",261},
[0x04AC]={"set_global_waypoint_ext","SetGlobalWaypointExt",262},
[0x04AD]={"set_local_waypoint_ext","SetLocalWaypointExt",264},
[0x04AE]={"execute_list_ext","ExecuteListExt",266},
[0x0500]={"set_ackermann_configuration","SetAckermannConfiguration",267},
[0x0501]={"set_skid_steer_effort","SetSkidSteerEffort",268},
[0x0503]={"set_stabilizer_effort","SetStabilizerEffort",269},
[0x0504]={"set_stabilizer_position","SetStabilizerPosition",271},
[0x0506]={"set_power_plant_configuration","SetPowerPlantConfiguration",273},
[0x0512]={"set_parking_brake","SetParkingBrake",281},
[0x0513]={"set_illumination_state","SetIlluminationState",282},
[0x0515]={"reset_odometry","ResetOdometry",284},
[0x0601]={"set_joint_effort","SetJointEffort",285},
[0x0602]={"set_joint_positions","SetJointPositions",287},
[0x0603]={"set_joint_velocity","SetJointVelocity",290},
[0x0610]={"set_end_effector_pose","SetEndEffectorPose",293},
[0x0612]={"set_end_effector_velocity_state","SetEndEffectorVelocityState",294},
[0x0613]={"set_actuator_force_torques","SetActuatorForceTorques",295},
[0x061E]={"execute_list","ExecuteList",298},
[0x0621]={"set_pan_tilt_joint_effort","SetPanTiltJointEffort",299},
[0x0622]={"set_pan_tilt_joint_positions","SetPanTiltJointPositions",300},
[0x0627]={"set_pan_tilt_motion_profile","SetPanTiltMotionProfile",301},
[0x0801]={"confirm_sensor_configuration","ConfirmSensorConfiguration",302},
[0x0802]={"set_range_sensor_configuration","SetRangeSensorConfiguration",315},
[0x0803]={"set_visual_sensor_configuration","SetVisualSensorConfiguration",318},
[0x0804]={"set_digital_video_sensor_configuration","SetDigitalVideoSensorConfiguration",321},
[0x0805]={"control_digital_video_sensor_stream","ControlDigitalVideoSensorStream",324},
[0x0806]={"set_analog_video_sensor_configuration","SetAnalogVideoSensorConfiguration",325},
[0x0807]={"set_still_image_sensor_configuration","SetStillImageSensorConfiguration",328},
[0x0808]={"register_digital_resource_endpoint","RegisterDigitalResourceEndpoint",331},
[0x0809]={"remove_digital_resource_endpoint","RemoveDigitalResourceEndpoint",335},
[0x080A]={"confirm_digital_resource_endpoint","ConfirmDigitalResourceEndpoint",336},
[0x0810]={"control_digital_video_sensor_recording","ControlDigitalVideoSensorRecording",337},
[0x0818]={"set_digital_audio_output_source","SetDigitalAudioOutputSource",338},
[0x081A]={"set_video_illuminator_configuration","SetVideoIlluminatorConfiguration",341},
[0x0B00]={"register_services","RegisterServices",344},
[0x2001]={"query_authority","QueryAuthority",346,report=0x4001},
[0x2002]={"query_status","QueryStatus",347,report=0x4002},
[0x2003]={"query_timeout","QueryTimeout",348,report=0x4003},
[0x200D]={"query_control","QueryControl",349,report=0x400D},
[0x21F0]={"query_events","QueryEvents",350,report=0x41F0},
[0x21F2]={"query_event_timeout","QueryEventTimeout",355,report=0x41F2},
[0x2202]={"query_heartbeat_pulse","QueryHeartbeatPulse",356,report=0x4202},
[0x2402]={"query_global_pose","QueryGlobalPose",357,report=0x4402},
[0x2404]={"query_velocity_state","QueryVelocityState",358,report=0x4404},
[0x2405]={"query_wrench_effort","QueryWrenchEffort",359,report=0x4405},
[0x2407]={"query_global_vector","QueryGlobalVector",360,report=0x4407},
[0x2408]={"query_local_vector","QueryLocalVector",361,report=0x4408},
[0x240A]={"query_travel_speed","QueryTravelSpeed",362,report=0x440A},
[0x240C]={"query_global_waypoint","QueryGlobalWaypoint",363,report=0x440C},
[0x240D]={"query_local_waypoint","QueryLocalWaypoint",364,report=0x440D},
[0x240F]={"query_global_path_segment","QueryGlobalPathSegment",365,report=0x440F},
[0x2410]={"query_local_path_segment","QueryLocalPathSegment",366,report=0x4410},
[0x2412]={"query_geomagnetic_property","QueryGeomagneticProperty",367,report=0x4412},
[0x2417]={"query_acceleration_state","QueryAccelerationState",368,report=0x4417},
[0x241A]={"query_element","QueryElement",369,report=0x441A},
[0x241B]={"query_element_list","QueryElementList",370,report=0x441B},
[0x241C]={"query_element_count","QueryElementCount",371,report=0x441C},
[0x241E]={"query_active_element","QueryActiveElement",372,report=0x441E},
[0x2423]={"query_global_operating_zone","QueryGlobalOperatingZone",373,report=0x4423},
[0x2424]={"query_excursion","QueryExcursion",374,report=0x4424},
[0x2425]={"query_global_loiter","QueryGlobalLoiter",375,report=0x4425},
[0x2426]={"query_local_loiter","QueryLocalLoiter",376,report=0x4426},
[0x2427]={"query_local_operating_zone","QueryLocalOperatingZone",377,report=0x4427},
[0x2428]={"query_gps_fix","QueryGPSFix",378,report=0x4428},
[0x2429]={"query_inertial_sensor_status","QueryInertialSensorStatus",379,report=0x4429},
[0x24A2]={"query_global_pose_ext","QueryGlobalPoseExt",380,report=0x44A2},
[0x24A4]={"query_velocity_state_ext","QueryVelocityStateExt",381,report=0x44A4},
[0x24A7]={"query_global_vector_ext","QueryGlobalVectorExt",382,report=0x44A7},
[0x24A8]={"query_local_vector_ext","QueryLocalVectorExt",383,report=0x44A8},
[0x24AA]={"query_travel_speed_ext","QueryTravelSpeedExt",384,report=0x44AA},
[0x24AC]={"query_global_waypoint_ext","QueryGlobalWaypointExt",385,report=0x44AC},
[0x24AD]={"query_local_waypoint_ext","QueryLocalWaypointExt",386,report=0x44AD},
[0x24AF]={"query_global_path_segment_ext","QueryGlobalPathSegmentExt",387,report=0x44AF},
[0x24B0]={"query_local_path_segment_ext","QueryLocalPathSegmentExt",388,report=0x44B0},
[0x24B7]={"query_acceleration_state_ext","QueryAccelerationStateExt",389,report=0x44B7},
[0x2500]={"query_ackermann_configuration","QueryAckermannConfiguration",390,report=0x4500},
[0x2501]={"query_skid_steer_effort","QuerySkidSteerEffort",391,report=0x4501},
[0x2502]={"query_platform_specifications","QueryPlatformSpecifications",392,report=0x4502},
[0x2503]={"query_stabilizer_effort","QueryStabilizerEffort",393,report=0x4503},
[0x2504]={"query_stabilizer_position","QueryStabilizerPosition",395,report=0x4504},
[0x2505]={"query_stabilizer_capabilities","QueryStabilizerCapabilities",396,report=0x4505},
[0x2506]={"query_power_plant_configuration","QueryPowerPlantConfiguration",397,report=0x4506},
[0x2507]={"query_power_plant_capabilities","QueryPowerPlantCapabilities",398,report=0x4507},
[0x2508]={"query_power_plant_status","QueryPowerPlantStatus",399,report=0x4508},
[0x2512]={"query_parking_brake","QueryParkingBrake",400,report=0x4512},
[0x2513]={"query_illumination_state","QueryIlluminationState",401,report=0x4513},
[0x2514]={"query_illumination_configuration","QueryIlluminationConfiguration",402,report=0x4514},
[0x2515]={"query_odometry","QueryOdometry",403,report=0x4515},
[0x2600]={"query_manipulator_specifications","QueryManipulatorSpecifications",404,report=0x4600},
[0x2601]={"query_joint_effort","QueryJointEffort",405,report=0x4601},
[0x2603]={"query_joint_velocity","QueryJointVelocity",406,report=0x4603},
[0x2605]={"query_joint_force_torques","QueryJointForceTorques",407,report=0x4605},
[0x2608]={"query_commanded_joint_positions","QueryCommandedJointPositions",408,report=0x4608},
[0x2610]={"query_commanded_end_effector_pose","QueryCommandedEndEffectorPose",409,report=0x4610},
[0x2611]={"query_commanded_joint_velocity","QueryCommandedJointVelocity",410,report=0x4611},
[0x2612]={"query_commanded_end_effector_velocity_state","QueryCommandedEndEffectorVelocityState",411,report=0x4612},
[0x2613]={"query_commanded_actuator_force_torques","QueryCommandedActuatorForceTorques",412,report=0x4613},
[0x2615]={"query_end_effector_pose","QueryEndEffectorPose",413,report=0x4615},
[0x2616]={"query_end_effector_velocity_state","QueryEndEffectorVelocityState",414,report=0x4616},
[0x261E]={"query_active_element","QueryActiveElement",415,report=0x461E},
[0x2620]={"query_pan_tilt_specifications","QueryPanTiltSpecifications",416,report=0x4620},
[0x2621]={"query_pan_tilt_joint_effort","QueryPanTiltJointEffort",417,report=0x4621},
[0x2622]={"query_pan_tilt_joint_positions","QueryPanTiltJointPositions",418,report=0x4622},
[0x2623]={"query_pan_tilt_joint_velocity","QueryPanTiltJointVelocity",419,report=0x4623},
[0x2627]={"query_pan_tilt_motion_profile","QueryPanTiltMotionProfile",420,report=0x4627},
[0x2628]={"query_commanded_pan_tilt_joint_positions","QueryCommandedPanTiltJointPositions",421,report=0x4628},
[0x2801]={"query_range_sensor_capabilities","QueryRangeSensorCapabilities",422,report=0x4801},
[0x2802]={"query_range_sensor_configuration","QueryRangeSensorConfiguration",424,report=0x4802},
[0x2803]={"query_range_sensor_data","QueryRangeSensorData",426,report=0x4803},
[0x2804]={"query_range_sensor_compressed_data","QueryRangeSensorCompressedData",428,report=0x4804},
[0x2805]={"query_sensor_geometric_properties","QuerySensorGeometricProperties",430,report=0x4805},
[0x2806]={"query_visual_sensor_capabilities","QueryVisualSensorCapabilities",432,report=0x4806},
[0x2807]={"query_visual_sensor_configuration","QueryVisualSensorConfiguration",434,report=0x4807},
[0x2809]={"query_digital_video_sensor_configuration","QueryDigitalVideoSensorConfiguration",436,report=0x4809},
[0x280A]={"query_visual_sensor_capabilities_ext","QueryVisualSensorCapabilitiesExt",438,report=0x480A},
[0x280B]={"query_force_torque_capabilities","QueryForceTorqueCapabilities",440,report=0x480B},
[0x280C]={"query_force_torque","QueryForceTorque",442,report=0x480C},
[0x2810]={"query_analog_video_sensor_capabilities","QueryAnalogVideoSensorCapabilities",444,report=0x4810},
[0x2811]={"query_analog_video_sensor_configuration","QueryAnalogVideoSensorConfiguration",445,report=0x4811},
[0x2812]={"query_still_image_sensor_capabilities","QueryStillImageSensorCapabilities",446,report=0x4812},
[0x2813]={"query_still_image_sensor_configuration","QueryStillImageSensorConfiguration",448,report=0x4813},
[0x2816]={"query_digital_resource_endpoint","QueryDigitalResourceEndpoint",450,report=0x4816},
[0x2818]={"query_digital_audio_output_source","QueryDigitalAudioOutputSource",451,report=0x4818},
[0x2819]={"query_digital_audio_output_capabilities","QueryDigitalAudioOutputCapabilities",452,report=0x4819},
[0x281A]={"query_video_illuminator_configuration","QueryVideoIlluminatorConfiguration",453,report=0x481A},
[0x281B]={"query_video_illuminator_capabilities","QueryVideoIlluminatorCapabilities",455,report=0x481B},
[0x281C]={"query_still_image_data_ext","QueryStillImageDataExt",456,report=0x481C},
[0x281D]={"query_digital_video_sensor_capabilities_ext","QueryDigitalVideoSensorCapabilitiesExt",458,report=0x481D},
[0x281E]={"query_digital_video_sensor_status","QueryDigitalVideoSensorStatus",460,report=0x481E},
[0x2B00]={"query_identification","QueryIdentification",461,report=0x4B00},
[0x2B01]={"query_configuration","QueryConfiguration",462,report=0x4B01},
[0x2B02]={"query_subsystem_list","QuerySubsystemList",463,report=0x4B02},
[0x2B03]={"query_services","QueryServices",464,report=0x4B03},
[0x2B04]={"query_service_list","QueryServiceList",468,report=0x4B04},
[0x4001]={"report_authority","ReportAuthority",474,query=0x2001},
[0x4002]={"report_status","ReportStatus",475,query=0x2002},
[0x4003]={"report_timeout","ReportTimeout",476,query=0x2003},
[0x400D]={"report_control","ReportControl",477,query=0x200D},
[0x41F0]={"report_events","ReportEvents",478,query=0x21F0},
[0x41F1]={"event","Event",480},
[0x41F2]={"report_event_timeout","ReportEventTimeout",481,query=0x21F2},
[0x41F6]={"command_event","CommandEvent",482},
[0x4202]={"report_heartbeat_pulse","ReportHeartbeatPulse",483,query=0x2202},
[0x4402]={"report_global_pose","ReportGlobalPose",484,query=0x2402},
[0x4404]={"report_velocity_state","ReportVelocityState",485,query=0x2404},
[0x4405]={"report_wrench_effort","ReportWrenchEffort",486,query=0x2405},
[0x4407]={"report_global_vector","ReportGlobalVector",487,query=0x2407},
[0x4408]={"report_local_vector","ReportLocalVector",488,query=0x2408},
[0x440A]={"report_travel_speed","ReportTravelSpeed",489,query=0x240A},
[0x440C]={"report_global_waypoint","ReportGlobalWaypoint",490,query=0x240C},
[0x440D]={"report_local_waypoint","ReportLocalWaypoint",491,query=0x240D},
[0x440F]={"report_global_path_segment","ReportGlobalPathSegment",492,query=0x240F},
[0x4410]={"report_local_path_segment","ReportLocalPathSegment",493,query=0x2410},
[0x4412]={"report_geomagnetic_property","ReportGeomagneticProperty",494,query=0x2412},
[0x4417]={"report_acceleration_state","ReportAccelerationState",495,query=0x2417},
[0x441A]={"report_element","ReportElement",496,query=0x241A},
[0x441B]={"report_element_list","ReportElementList",497,query=0x241B},
[0x441C]={"report_element_count","ReportElementCount",499,query=0x241C},
[0x441E]={"report_active_element","ReportActiveElement",500,query=0x241E},
[0x4423]={"report_global_operating_zone","ReportGlobalOperatingZone",501,query=0x2423},
[0x4424]={"report_excursion","ReportExcursion",502,query=0x2424},
[0x4425]={"report_global_loiter","ReportGlobalLoiter",504,query=0x2425},
[0x4426]={"report_local_loiter","ReportLocalLoiter",505,query=0x2426},
[0x4427]={"report_local_operating_zone","ReportLocalOperatingZone",506,query=0x2427},
[0x4428]={"report_gps_fix","ReportGPSFix",507,query=0x2428},
[0x4429]={"report_inertial_sensor_status","ReportInertialSensorStatus",511,query=0x2429},
[0x44A2]={"report_global_pose_ext","ReportGlobalPoseExt",512,query=0x24A2},
[0x44A4]={"report_velocity_state_ext","ReportVelocityStateExt",513,query=0x24A4},
[0x44A7]={"report_global_vector_ext","ReportGlobalVectorExt",518,query=0x24A7},
[0x44A8]={"report_local_vector_ext","ReportLocalVectorExt",519,query=0x24A8},
[0x44AA]={"report_travel_speed_ext","ReportTravelSpeedExt",520,query=0x24AA},
[0x44AC]={"report_global_waypoint_ext","ReportGlobalWaypointExt",521,query=0x24AC},
[0x44AD]={"report_local_waypoint_ext","ReportLocalWaypointExt",523,query=0x24AD},
[0x44AF]={"report_global_path_segment_ext","ReportGlobalPathSegmentExt",524,query=0x24AF},
[0x44B0]={"report_local_path_segment_ext","ReportLocalPathSegmentExt",527,query=0x24B0},
[0x44B7]={"report_acceleration_state_ext","ReportAccelerationStateExt",530,query=0x24B7},
[0x4500]={"report_ackermann_configuration","ReportAckermannConfiguration",531,query=0x2500},
[0x4501]={"report_skid_steer_effort","ReportSkidSteerEffort",532,query=0x2501},
[0x4502]={"report_platform_specifications","ReportPlatformSpecifications",533,query=0x2502},
[0x4503]={"report_stabilizer_effort","ReportStabilizerEffort",538,query=0x2503},
[0x4504]={"report_stabilizer_position","ReportStabilizerPosition",539,query=0x2504},
[0x4505]={"report_stabilizer_capabilities","ReportStabilizerCapabilities",541,query=0x2505},
[0x4506]={"report_power_plant_configuration","ReportPowerPlantConfiguration",545,query=0x2506},
[0x4507]={"report_power_plant_capabilities","ReportPowerPlantCapabilities",546,query=0x2507},
[0x4508]={"report_power_plant_status","ReportPowerPlantStatus",555,query=0x2508},
[0x4512]={"report_parking_brake","ReportParkingBrake",563,query=0x2512},
[0x4513]={"report_illumination_state","ReportIlluminationState",564,query=0x2513},
[0x4514]={"report_illumination_configuration","ReportIlluminationConfiguration",565,query=0x2514},
[0x4515]={"report_odometry","ReportOdometry",567,query=0x2515},
[0x4600]={"report_manipulator_specifications","ReportManipulatorSpecifications",568,query=0x2600},
[0x4601]={"report_joint_effort","ReportJointEffort",576,query=0x2601},
[0x4603]={"report_joint_velocity","ReportJointVelocity",577,query=0x2603},
[0x4605]={"report_joint_force_torques","ReportJointForceTorques",578,query=0x2605},
[0x4608]={"report_commanded_joint_positions","ReportCommandedJointPositions",579,query=0x2608},
[0x4610]={"report_commanded_end_effector_pose","ReportCommandedEndEffectorPose",580,query=0x2610},
[0x4611]={"report_commanded_joint_velocity","ReportCommandedJointVelocity",581,query=0x2611},
[0x4612]={"report_commanded_end_effector_velocity_state","ReportCommandedEndEffectorVelocityState",582,query=0x2612},
[0x4613]={"report_commanded_actuator_force_torques","ReportCommandedActuatorForceTorques",583,query=0x2613},
[0x4615]={"report_end_effector_pose","ReportEndEffectorPose",584,query=0x2615},
[0x4616]={"report_end_effector_velocity_state","ReportEndEffectorVelocityState",585,query=0x2616},
[0x461E]={"report_active_element","ReportActiveElement",586,query=0x261E},
[0x4620]={"report_pan_tilt_specifications","ReportPanTiltSpecifications",587,query=0x2620},
[0x4621]={"report_pan_tilt_joint_effort","ReportPanTiltJointEffort",588,query=0x2621},
[0x4622]={"report_pan_tilt_joint_positions","ReportPanTiltJointPositions",589,query=0x2622},
[0x4623]={"report_pan_tilt_joint_velocity","ReportPanTiltJointVelocity",590,query=0x2623},
[0x4627]={"report_pan_tilt_motion_profile","ReportPanTiltMotionProfile",591,query=0x2627},
[0x4628]={"report_commanded_pan_tilt_joint_positions","ReportCommandedPanTiltJointPositions",592,query=0x2628},
[0x4801]={"report_range_sensor_capabilities","ReportRangeSensorCapabilities",593,query=0x2801},
[0x4802]={"report_range_sensor_configuration","ReportRangeSensorConfiguration",597,query=0x2802},
[0x4803]={"report_range_sensor_data","ReportRangeSensorData",598,query=0x2803},
[0x4804]={"report_range_sensor_compressed_data","ReportRangeSensorCompressedData",605,query=0x2804},
[0x4805]={"report_sensor_geometric_properties","ReportSensorGeometricProperties",608,query=0x2805},
[0x4806]={"report_visual_sensor_capabilities","ReportVisualSensorCapabilities",613,query=0x2806},
[0x4807]={"report_visual_sensor_configuration","ReportVisualSensorConfiguration",622,query=0x2807},
[0x4809]={"report_digital_video_sensor_configuration","ReportDigitalVideoSensorConfiguration",623,query=0x2809},
[0x480A]={"report_visual_sensor_capabilities_ext","ReportVisualSensorCapabilitiesExt",624,query=0x280A},
[0x480B]={"report_force_torque_capabilities","ReportForceTorqueCapabilities",628,query=0x280B},
[0x480C]={"report_force_torque","ReportForceTorque",630,query=0x280C},
[0x4810]={"report_analog_video_sensor_capabilities","ReportAnalogVideoSensorCapabilities",632,query=0x2810},
[0x4811]={"report_analog_video_sensor_configuration","ReportAnalogVideoSensorConfiguration",635,query=0x2811},
[0x4812]={"report_still_image_sensor_capabilities","ReportStillImageSensorCapabilities",636,query=0x2812},
[0x4813]={"report_still_image_sensor_configuration","ReportStillImageSensorConfiguration",640,query=0x2813},
[0x4816]={"report_digital_resource_endpoint","ReportDigitalResourceEndpoint",641,query=0x2816},
[0x4818]={"report_digital_audio_output_source","ReportDigitalAudioOutputSource",642,query=0x2818},
[0x4819]={"report_digital_audio_output_capabilities","ReportDigitalAudioOutputCapabilities",643,query=0x2819},
[0x481A]={"report_video_illuminator_configuration","ReportVideoIlluminatorConfiguration",647,query=0x281A},
[0x481B]={"report_video_illuminator_capabilities","ReportVideoIlluminatorCapabilities",648,query=0x281B},
[0x481C]={"report_still_image_data_ext","ReportStillImageDataExt",653,query=0x281C},
[0x481D]={"report_digital_video_sensor_capabilities_ext","ReportDigitalVideoSensorCapabilitiesExt",656,query=0x281D},
[0x481E]={"report_digital_video_sensor_status","ReportDigitalVideoSensorStatus",659,query=0x281E},
[0x4B00]={"report_identification","ReportIdentification",661,query=0x2B00},
[0x4B01]={"report_configuration","ReportConfiguration",662,query=0x2B01},
[0x4B02]={"report_subsystem_list","ReportSubsystemList",666,query=0x2B02},
[0x4B03]={"report_services","ReportServices",668,query=0x2B03},
[0x4B04]={"report_service_list","ReportServiceList",673,query=0x2B04},
}
-- Messages of mobility 1.0, which differ.
local sae_messages_1_0 = {
[0x0408]={"set_local_vector","SetLocalVector",678},
[0x4408]={"report_local_vector","ReportLocalVector",679},
}
local header_structure, transport_structure = 1, 3
-- Codes by subindex, from 1; of SAE JAUS by segment.
local ra_ranks = {0x0001,0x0002,0x0003,0x0004,0x0005,0x0006,0x0007,0x0008,0x0009,0x000A,0x000B,0x000C,0x000D,0x000E,0x000F,0x0010,0x0011,0x01F0,0x01F1,0x01F2,0x01F3,0x01F4,0x0200,0x0201,0x0202,0x0405,0x0406,0x0407,0x0408,0x040A,0x040C,0x040D,0x040F,0x0410,0x0601,0x0602,0x0603,0x0604,0x0605,0x0606,0x0607,0x0608,0x0801,0x0802,0x0805,0x0806,0x0A20,0x0A21,0x0A24,0x0A25,0x0D01,0x0E00,0x0E01,0x0E02,0x0E03,0x0E04,0x0E05,0x0E06,0x2001,0x2002,0x200D,0x2011,0x21F0,0x2200,0x2201,0x2202,0x2400,0x2401,0x2402,0x2403,0x2404,0x2405,0x2406,0x2407,0x2408,0x240A,0x240B,0x240C,0x240D,0x240E,0x240F,0x2410,0x2600,0x2601,0x2602,0x2603,0x2604,0x2605,0x2800,0x2801,0x2802,0x2804,0x2805,0x2806,0x2807,0x2A21,0x2A22,0x2A23,0x2B00,0x2B01,0x2B02,0x2B03,0x2D00,0x2D01,0x2E00,0x2E01,0x4001,0x4002,0x400D,0x4011,0x41F0,0x41F1,0x4200,0x4201,0x4202,0x4400,0x4401,0x4402,0x4403,0x4404,0x4405,0x4406,0x4407,0x4408,0x440A,0x440B,0x440C,0x440D,0x440E,0x440F,0x4410,0x4600,0x4601,0x4602,0x4603,0x4604,0x4605,0x4800,0x4801,0x4802,0x4804,0x4805,0x4806,0x4807,0x4A20,0x4A21,0x4A22,0x4A23,0x4A24,0x4B00,0x4B01,0x4B02,0x4B03,0x4D00,0x4D01,0x4E00,0x4E01,0x0404}
local sae_ranks = {{0x0001,0x0002,0x0003,0x0004,0x0005,0x0006,0x0007,0x000D,0x000E,0x000F,0x0010,0x01F0,0x01F1,0x01F2,0x01F3,0x01F4,0x01F6,0x041A,0x041B,0x041C,0x041D,0x0B00,0x2001,0x2002,0x2003,0x200D,0x21F0,0x21F2,0x2202,0x241A,0x241B,0x241C,0x2B00,0x2B01,0x2B02,0x2B03,0x2B04,0x4001,0x4002,0x4003,0x400D,0x41F0,0x41F1,0x41F2,0x41F6,0x4202,0x441A,0x441B,0x441C,0x4B00,0x4B01,0x4B02,0x4B03,0x4B04},
{0x0402,0x0405,0x0407,0x0408,0x040A,0x040C,0x040D,0x0412,0x041E,0x0422,0x0423,0x0425,0x0426,0x0427,0x0428,0x0429,0x04A2,0x04A7,0x04A8,0x04AA,0x04AC,0x04AD,0x04AE,0x2402,0x2404,0x2405,0x2407,0x2408,0x240A,0x240C,0x240D,0x240F,0x2410,0x2412,0x2417,0x241E,0x2423,0x2424,0x2425,0x2426,0x2427,0x2428,0x2429,0x24A2,0x24A4,0x24A7,0x24A8,0x24AA,0x24AC,0x24AD,0x24AF,0x24B0,0x24B7,0x4402,0x4404,0x4405,0x4407,0x4408,0x440A,0x440C,0x440D,0x440F,0x4410,0x4412,0x4417,0x441E,0x4423,0x4424,0x4425,0x4426,0x4427,0x4428,0x4429,0x44A2,0x44A4,0x44A7,0x44A8,0x44AA,0x44AC,0x44AD,0x44AF,0x44B0,0x44B7},
{0x0801,0x0802,0x0803,0x0804,0x0805,0x0806,0x0807,0x0808,0x0809,0x080A,0x0810,0x0818,0x081A,0x2801,0x2802,0x2803,0x2804,0x2805,0x2806,0x2807,0x2809,0x280A,0x280B,0x280C,0x2810,0x2811,0x2812,0x2813,0x2816,0x2818,0x2819,0x281A,0x281B,0x281C,0x281D,0x281E,0x4801,0x4802,0x4803,0x4804,0x4805,0x4806,0x4807,0x4809,0x480A,0x480B,0x480C,0x4810,0x4811,0x4812,0x4813,0x4816,0x4818,0x4819,0x481A,0x481B,0x481C,0x481D,0x481E},
{0x0601,0x0602,0x0603,0x0610,0x0612,0x0613,0x061E,0x0621,0x0622,0x0627,0x2600,0x2601,0x2603,0x2605,0x2608,0x2610,0x2611,0x2612,0x2613,0x2615,0x2616,0x261E,0x2620,0x2621,0x2622,0x2623,0x2627,0x2628,0x4600,0x4601,0x4603,0x4605,0x4608,0x4610,0x4611,0x4612,0x4613,0x4615,0x4616,0x461E,0x4620,0x4621,0x4622,0x4623,0x4627,0x4628},
{0x0500,0x0501,0x0503,0x0504,0x0506,0x0512,0x0513,0x0515,0x2500,0x2501,0x2502,0x2503,0x2504,0x2505,0x2506,0x2507,0x2508,0x2512,0x2513,0x2514,0x2515,0x4500,0x4501,0x4502,0x4503,0x4504,0x4505,0x4506,0x4507,0x4508,0x4512,0x4513,0x4514,0x4515},
{},
{},
{},
{},
{},
{},
{},
{},
{},
{},
{},
}

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
