package tellosimulator.command;

/** Sample texts for each row of the command table, with their outcomes. */
final class CommandCases {

  private CommandCases() {}

  /** Row | text | method of the target and record; SI units, turns counter-clockwise. */
  static final String ACCEPTED =
      """
      COMMAND | command | EnterSdkMode[]
      TAKEOFF | takeoff | Takeoff[]
      LAND | land | Land[]
      STREAM_ON | streamon | Stream[on=true]
      STREAM_OFF | streamoff | Stream[on=false]
      EMERGENCY | emergency | Emergency[]
      STOP | stop | Stop[]
      UP | up 20 | Move[direction=UP, distance=0.2]
      UP | up 500 | Move[direction=UP, distance=5.0]
      DOWN | down 20 | Move[direction=DOWN, distance=0.2]
      DOWN | down 123.4 | Move[direction=DOWN, distance=1.234]
      LEFT | left 50 | Move[direction=LEFT, distance=0.5]
      LEFT | left 500.0 | Move[direction=LEFT, distance=5.0]
      RIGHT | right 50 | Move[direction=RIGHT, distance=0.5]
      RIGHT | right 20.5 | Move[direction=RIGHT, distance=0.205]
      FORWARD | forward 100 | Move[direction=FORWARD, distance=1.0]
      FORWARD | forward 35.234234 | Move[direction=FORWARD, distance=0.35234234000000003]
      BACK | back 100 | Move[direction=BACK, distance=1.0]
      BACK | back 20.25 | Move[direction=BACK, distance=0.2025]
      CW | cw 90 | Turn[angle=-1.5707963267948966]
      CW | cw -90 | Turn[angle=1.5707963267948966]
      CW | cw 0 | Turn[angle=-0.0]
      CW | cw 3600 | Turn[angle=-62.83185307179586]
      CCW | ccw 90 | Turn[angle=1.5707963267948966]
      CCW | ccw -180 | Turn[angle=-3.141592653589793]
      CCW | ccw 22.5 | Turn[angle=0.39269908169872414]
      FLIP | flip l | Flip[direction=LEFT]
      FLIP | flip r | Flip[direction=RIGHT]
      FLIP | flip f | Flip[direction=FORWARD]
      FLIP | flip b | Flip[direction=BACK]
      FLIP | flip left | Flip[direction=LEFT]
      FLIP | flip right | Flip[direction=RIGHT]
      FLIP | flip forward | Flip[direction=FORWARD]
      FLIP | flip back | Flip[direction=BACK]
      GO | go 100 0 0 50 | Go[way=Vec3[x=1.0, y=0.0, z=0.0], speed=0.5]
      GO | go -500 500 -500 100 | Go[way=Vec3[x=-5.0, y=5.0, z=-5.0], speed=1.0]
      GO | go 0 0 20.1 10 | Go[way=Vec3[x=0.0, y=0.0, z=0.201], speed=0.1]
      GO | go 0 -21 0 10.5 | Go[way=Vec3[x=0.0, y=-0.21, z=0.0], speed=0.105]
      CURVE | curve 25 -25 0 25 -75 0 20 | Curve[arc=Arc[center=Vec3[x=-0.25, y=-0.5, z=-0.0], radius=0.5590169943749475, outward=Vec3[x=0.4472135954999579, y=0.8944271909999159, z=0.0], along=Vec3[x=0.8944271909999159, y=-0.4472135954999579, z=0.0], angle=1.5707963267948966], speed=0.2]
      GO_TO_PAD | go 0 0 50 30 m1 | GoToPad[goal=Vec3[x=0.0, y=0.0, z=0.5], speed=0.3, pad=PadChoice[id=1]]
      GO_TO_PAD | go 10 -20 100 100 m8 | GoToPad[goal=Vec3[x=0.1, y=-0.2, z=1.0], speed=1.0, pad=PadChoice[id=8]]
      GO_TO_PAD | go 0 0 50 30 m-1 | GoToPad[goal=Vec3[x=0.0, y=0.0, z=0.5], speed=0.3, pad=PadChoice[id=-1]]
      GO_TO_PAD | go 0 0 50 30 m-2 | GoToPad[goal=Vec3[x=0.0, y=0.0, z=0.5], speed=0.3, pad=PadChoice[id=-2]]
      CURVE_OVER_PAD | curve 25 -25 50 25 -75 50 20 m3 | CurveOverPad[via=Vec3[x=0.25, y=-0.25, z=0.5], end=Vec3[x=0.25, y=-0.75, z=0.5], speed=0.2, pad=PadChoice[id=3]]
      JUMP | jump 100 -50 80 30 90 m1 m2 | Jump[leg=GoToPad[goal=Vec3[x=1.0, y=-0.5, z=0.8], speed=0.3, pad=PadChoice[id=1]], heading=1.5707963267948966, second=PadChoice[id=2]]
      JUMP | jump 0 0 100 100 -360 m-1 m-2 | Jump[leg=GoToPad[goal=Vec3[x=0.0, y=0.0, z=1.0], speed=1.0, pad=PadChoice[id=-1]], heading=-6.283185307179586, second=PadChoice[id=-2]]
      SPEED | speed 10 | SetSpeed[speed=0.1]
      SPEED | speed 100 | SetSpeed[speed=1.0]
      SPEED | speed 33.3 | SetSpeed[speed=0.33299999999999996]
      RC | rc 0 0 0 0 | Rc[sticks=Sticks[right=0.0, forward=0.0, up=0.0, clockwise=0.0]]
      RC | rc 1 2 3 4 | Rc[sticks=Sticks[right=1.0, forward=2.0, up=3.0, clockwise=4.0]]
      RC | rc -100 100 -100 100 | Rc[sticks=Sticks[right=-100.0, forward=100.0, up=-100.0, clockwise=100.0]]
      RC | rc 12.5 -0.25 99.99 -0 | Rc[sticks=Sticks[right=12.5, forward=-0.25, up=99.99, clockwise=-0.0]]
      RC | rc 00020 -007 0 0.0 | Rc[sticks=Sticks[right=20.0, forward=-7.0, up=0.0, clockwise=0.0]]
      WIFI | wifi name secret | SetNetwork[done=Reply[text=ok]]
      MON | mon | DetectPads[on=true]
      MOFF | moff | DetectPads[on=false]
      MDIRECTION | mdirection 0 | SetPadDirection[direction=0]
      MDIRECTION | mdirection 1 | SetPadDirection[direction=1]
      MDIRECTION | mdirection 2 | SetPadDirection[direction=2]
      AP | ap name secret | SetNetwork[done=Reply[text=OK,drone will reboot in 3s]]
      READ_SPEED | speed? | Read[reading=SPEED]
      READ_BATTERY | battery? | Read[reading=BATTERY]
      READ_TIME | time? | Read[reading=TIME]
      READ_WIFI | wifi? | Read[reading=WIFI]
      READ_SDK | sdk? | Read[reading=SDK]
      READ_SERIAL | sn? | Read[reading=SERIAL_NUMBER]
      READ_HEIGHT | height? | Read[reading=HEIGHT]
      READ_TEMPERATURE | temp? | Read[reading=TEMPERATURE]
      READ_ATTITUDE | attitude? | Read[reading=ATTITUDE]
      READ_BAROMETER | baro? | Read[reading=BAROMETER]
      READ_ACCELERATION | acceleration? | Read[reading=ACCELERATION]
      READ_TOF | tof? | Read[reading=TOF]
      READ_PAD | mid? | Read[reading=PAD]
      MOTOR_ON | motoron | SpinMotors[on=true]
      MOTOR_OFF | motoroff | SpinMotors[on=false]
      THROW_FLY | throwfly | Takeoff[]
      REBOOT | reboot | Reboot[]
      WIFI_CHANNEL | wifisetchannel 1 | SetNetwork[done=Reply[text=OK,drone will reboot in 3s]]
      WIFI_CHANNEL | wifisetchannel 14 | SetNetwork[done=Reply[text=OK,drone will reboot in 3s]]
      PORT | port 1025 65535 | SetPorts[statePort=1025, videoPort=65535]
      PORT | port 8890 11111 | SetPorts[statePort=8890, videoPort=11111]
      SET_FPS | setfps high | SetVideo[option=FRAMES_PER_SECOND, value=30]
      SET_FPS | setfps middle | SetVideo[option=FRAMES_PER_SECOND, value=15]
      SET_FPS | setfps low | SetVideo[option=FRAMES_PER_SECOND, value=5]
      SET_BIT_RATE | setbitrate 0 | SetVideo[option=BIT_RATE, value=0]
      SET_BIT_RATE | setbitrate 5 | SetVideo[option=BIT_RATE, value=5]
      SET_RESOLUTION | setresolution high | SetVideo[option=LINES, value=720]
      SET_RESOLUTION | setresolution low | SetVideo[option=LINES, value=480]
      MULTI_WIFI | multiwifi name secret | Acknowledge[reply=Reply[text=ok]]
      DOWN_VISION | downvision 0 | SetVideo[option=DOWNWARD, value=0]
      DOWN_VISION | downvision 1 | SetVideo[option=DOWNWARD, value=1]
      KEEP_ALIVE | keepalive | Acknowledge[reply=Reply[text=ok]]
      READ_ACTIVATION | active? | Read[reading=ACTIVATION]
      READ_HARDWARE | hardware? | Read[reading=HARDWARE]
      READ_WIFI_VERSION | wifiversion? | Read[reading=WIFI_VERSION]
      READ_AP | ap? | Read[reading=JOINED_NETWORK]
      READ_SSID | ssid? | Read[reading=OWN_NETWORK]
      BOARD_LED | EXT led 0 128 255 | Light[order=Shine[effect=LampEffect[mode=STEADY, hertz=0.0, first=33023, second=33023]], reply=Reply[text=led ok]]
      BOARD_LED_BREATHE | EXT led br 0.1 0 128 255 | Light[order=Shine[effect=LampEffect[mode=BREATHE, hertz=0.1, first=33023, second=0]], reply=Reply[text=led ok]]
      BOARD_LED_BLINK | EXT led bl 2.5 0 1 2 253 254 255 | Light[order=Shine[effect=LampEffect[mode=BLINK, hertz=2.5, first=258, second=16645887]], reply=Reply[text=led ok]]
      BOARD_MATRIX | EXT mled g rbp0 | Light[order=Show[effect=MatrixEffect[pictures=[MatrixPicture[red=5, blue=6]], move=NONE, hertz=0.0]], reply=Reply[text=matrix ok]]
      BOARD_MATRIX_MOVE | EXT mled l r 2.5 - + | Light[order=Show[effect=MatrixEffect[pictures=[MatrixPicture[red=1040187392, blue=0], MatrixPicture[red=0, blue=0], MatrixPicture[red=8831493474304, blue=0]], move=LEFT, hertz=2.5]], reply=Reply[text=matrix ok]]
      BOARD_MATRIX_CHARACTER | EXT mled s p A | Light[order=Show[effect=MatrixEffect[pictures=[MatrixPicture[red=9607679674819100, blue=9607679674819100]], move=NONE, hertz=0.0]], reply=Reply[text=matrix ok]]
      BOARD_MATRIX_BOOT | EXT mled sg rbp0 | Light[order=Greet[picture=MatrixPicture[red=5, blue=6]], reply=Reply[text=matrix ok]]
      BOARD_MATRIX_CLEAR | EXT mled sc | Light[order=Greet[picture=MatrixPicture[red=0, blue=0]], reply=Reply[text=matrix ok]]
      BOARD_MATRIX_LIGHT | EXT mled sl 255 | Light[order=Dim[brightness=255], reply=Reply[text=matrix ok]]
      BOARD_TOF | EXT tof? | Read[reading=BOARD_TOF]
      BOARD_VERSION | EXT version? | Read[reading=BOARD_VERSION]
      """;

  /** Row | text | reply; "unknown" stands for the unknown command with its echo. */
  static final String REFUSED =
      """
      COMMAND | command 1 | unknown
      TAKEOFF | takeoff 80 | unknown
      LAND | land now | unknown
      STREAM_ON | streamon 1 | unknown
      STREAM_OFF | streamoff 1 | unknown
      EMERGENCY | emergency! | unknown
      STOP | stop 1 | unknown
      UP | up 19.99 | out of range
      UP | up 500.01 | out of range
      UP | up | unknown
      DOWN | down 0 | out of range
      DOWN | down -50 | out of range
      LEFT | left 501 | out of range
      LEFT | left x | unknown
      RIGHT | right 19 | out of range
      RIGHT | right 50 50 | unknown
      FORWARD | forward 0.2 | out of range
      FORWARD | forward 999999999999999 | out of range
      FORWARD | forward 9999999999999999 | unknown
      FORWARD | forward | unknown
      BACK | back 10 | out of range
      BACK | back fifty | unknown
      CW | cw | unknown
      CW | cw l | unknown
      CCW | ccw | unknown
      CCW | ccw 90 1 | unknown
      FLIP | flip x | out of range
      FLIP | flip L | out of range
      FLIP | flip up | out of range
      FLIP | flip | unknown
      FLIP | flip l r | unknown
      GO | go -10 15 0 26 | out of range
      GO | go 0 -12 17 20 | out of range
      GO | go 20 20 20 50 | out of range
      GO | go -20 0 0 50 | out of range
      GO | go 501 0 0 50 | out of range
      GO | go 0 0 -500.5 50 | out of range
      GO | go 100 0 0 9.9 | out of range
      GO | go 100 0 0 101 | out of range
      GO | go 100 0 0 | unknown
      GO | go 100 0 x 50 | unknown
      GO_TO_PAD | go 0 0 50 30 m0 | out of range
      GO_TO_PAD | go 0 0 50 30 m9 | out of range
      GO_TO_PAD | go 0 0 50 30 M1 | out of range
      GO_TO_PAD | go 0 0 501 30 m1 | out of range
      GO_TO_PAD | go 0 0 50 5 m1 | out of range
      GO_TO_PAD | go x 0 50 30 m1 | unknown
      CURVE | curve 20 20 20 100 0 0 30 | out of range
      CURVE | curve 100 0 0 20 -20 0 30 | out of range
      CURVE | curve 25 -25 0 25 -501 0 20 | out of range
      CURVE | curve 25 -25 0 25 -75 0 9 | out of range
      CURVE | curve 25 -25 0 25 -75 0 61 | out of range
      CURVE | curve 50 0 0 100 0 0 30 | error Radius is too large!
      CURVE | curve 50 0 0 50 0 0 30 | error Radius is too large!
      CURVE | curve 30 30 0 60 0 0 30 | error Radius is too large!
      CURVE | curve 250 1 0 500 0 0 30 | error Radius is too large!
      CURVE | curve 25 -25 0 25 -75 20 | unknown
      CURVE_OVER_PAD | curve 25 -25 0 25 -75 0 20 m0 | out of range
      CURVE_OVER_PAD | curve 25 -25 0 25 -75 0 61 m1 | out of range
      CURVE_OVER_PAD | curve 25 -25 0 25 -75 x 20 m1 | unknown
      JUMP | jump 0 0 100 101 0 m1 m2 | out of range
      JUMP | jump 0 0 100 100 0 m1 m9 | out of range
      JUMP | jump 0 0 100 100 0 m0 m2 | out of range
      JUMP | jump 0 0 100 100 0 m1 | unknown
      JUMP | jump 0 0 100 100 n m1 m2 | unknown
      SPEED | speed 9.99 | error
      SPEED | speed 101 | error
      SPEED | speed -50 | error
      SPEED | speed | unknown
      SPEED | speed fast | unknown
      RC | rc 101 0 0 0 | out of range
      RC | rc 0 -100.01 0 0 | out of range
      RC | rc 0 0 1000 0 | out of range
      RC | rc 0 0 0 -101 | out of range
      RC | rc 0 0 0 | unknown
      RC | rc 0 0 0 0 0 | unknown
      RC | rc 0 0 0 +5 | unknown
      RC | rc | unknown
      WIFI | wifi name | unknown
      WIFI | wifi name secret 1 | unknown
      MON | mon 1 | unknown
      MOFF | moff? | unknown
      MDIRECTION | mdirection 3 | error
      MDIRECTION | mdirection -1 | error
      MDIRECTION | mdirection 1.5 | error
      MDIRECTION | mdirection down | unknown
      MDIRECTION | mdirection | unknown
      AP | ap name | unknown
      AP | ap a b c | unknown
      READ_SPEED | speed? 1 | unknown
      READ_BATTERY | battery | unknown
      READ_TIME | time | unknown
      READ_WIFI | wifi | unknown
      READ_SDK | sdk | unknown
      READ_SERIAL | sn | unknown
      READ_HEIGHT | height | unknown
      READ_TEMPERATURE | temperature? | unknown
      READ_ATTITUDE | attitude?? | unknown
      READ_BAROMETER | barometer? | unknown
      READ_ACCELERATION | accel? | unknown
      READ_TOF | tof | unknown
      READ_PAD | mid | unknown
      MOTOR_ON | motoron 1 | unknown
      MOTOR_OFF | motorof | unknown
      THROW_FLY | throw fly | unknown
      REBOOT | reboot 3 | unknown
      WIFI_CHANNEL | wifisetchannel 0 | error
      WIFI_CHANNEL | wifisetchannel 15 | error
      WIFI_CHANNEL | wifisetchannel auto | unknown
      PORT | port 1024 11111 | error
      PORT | port 8890 65536 | error
      PORT | port 8890 | unknown
      SET_FPS | setfps 30 | error
      SET_FPS | setfps | unknown
      SET_BIT_RATE | setbitrate 6 | error
      SET_BIT_RATE | setbitrate 2.5 | error
      SET_BIT_RATE | setbitrate high | unknown
      SET_BIT_RATE | setbitrate | unknown
      SET_RESOLUTION | setresolution middle | error
      SET_RESOLUTION | setresolution | unknown
      MULTI_WIFI | multiwifi name | unknown
      DOWN_VISION | downvision 2 | error
      DOWN_VISION | downvision | unknown
      KEEP_ALIVE | keepalive 1 | unknown
      READ_ACTIVATION | active | unknown
      READ_HARDWARE | hardware | unknown
      READ_WIFI_VERSION | wifiversion | unknown
      READ_AP | ap | unknown
      READ_SSID | ssid | unknown
      BOARD_LED | EXT led 0 0 256 | led error
      BOARD_LED | EXT led 0 0 -1 | led error
      BOARD_LED | EXT led 0 0 | unknown
      BOARD_LED | EXT led red | unknown
      BOARD_LED_BREATHE | EXT led br 2.6 0 0 0 | led error
      BOARD_LED_BREATHE | EXT led br 0.09 0 0 0 | led error
      BOARD_LED_BREATHE | EXT led br fast 0 0 0 | unknown
      BOARD_LED_BLINK | EXT led bl 1 0 0 0 0 0 300 | led error
      BOARD_LED_BLINK | EXT led bl 1 0 0 0 0 0 | unknown
      BOARD_MATRIX | EXT mled g | unknown
      BOARD_MATRIX_MOVE | EXT mled x r 1 hello | matrix error
      BOARD_MATRIX_MOVE | EXT mled l g 1 hello | matrix error
      BOARD_MATRIX_MOVE | EXT mled l r 3 hello | matrix error
      BOARD_MATRIX_MOVE | EXT mled l r 1 | unknown
      BOARD_MATRIX_CHARACTER | EXT mled s g A | matrix error
      BOARD_MATRIX_CHARACTER | EXT mled s p | unknown
      BOARD_MATRIX_BOOT | EXT mled sg | unknown
      BOARD_MATRIX_CLEAR | EXT mled sc 1 | unknown
      BOARD_MATRIX_LIGHT | EXT mled sl 256 | matrix error
      BOARD_MATRIX_LIGHT | EXT mled sl | unknown
      BOARD_TOF | EXT tof | unknown
      BOARD_TOF | EXT  tof? | unknown
      BOARD_VERSION | EXT version | unknown
      """;
}
