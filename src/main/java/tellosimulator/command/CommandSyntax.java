package tellosimulator.command;

import static tellosimulator.command.GeometryRules.CUBE;
import static tellosimulator.command.Parameter.angle;
import static tellosimulator.command.Parameter.choice;
import static tellosimulator.command.Parameter.cm;
import static tellosimulator.command.Parameter.color;
import static tellosimulator.command.Parameter.curveSpeed;
import static tellosimulator.command.Parameter.hertz;
import static tellosimulator.command.Parameter.named;
import static tellosimulator.command.Parameter.pad;
import static tellosimulator.command.Parameter.rgb;
import static tellosimulator.command.Parameter.speed;
import static tellosimulator.command.Parameter.stick;
import static tellosimulator.command.Parameter.text;
import static tellosimulator.command.Parameter.whole;
import static tellosimulator.command.Parameter.word;
import static tellosimulator.command.Row.board;
import static tellosimulator.command.Row.move;
import static tellosimulator.command.Row.read;
import static tellosimulator.command.Row.row;
import static tellosimulator.command.Row.turn;
import static tellosimulator.profile.Sdk.SDK_1_3;
import static tellosimulator.profile.Sdk.SDK_2_0;
import static tellosimulator.profile.Sdk.SDK_3_0;

import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.controller.Direction;
import tellosimulator.controller.Sticks;
import tellosimulator.extension.LampEffect;
import tellosimulator.extension.LightOrder;
import tellosimulator.extension.MatrixEffect;
import tellosimulator.extension.MatrixPicture;
import tellosimulator.model.VideoOption;
import tellosimulator.profile.Profile;
import tellosimulator.profile.Sdk;
import tellosimulator.words.Phrase;

/**
 * The table of all commands. A row defines a command's syntax, the SDK that introduced it, the
 * ranges of its parameters, how the command is treated while another one runs, and the record that
 * represents the parsed command.
 *
 * <p>To add a command, add a row here, a record in {@link Command} and an entry in {@link
 * DroneCommands}. {@code docs/protocol.md} is generated from these rows.
 */
public enum CommandSyntax {
  COMMAND(
      row("command", SDK_1_3).whileBusy(BusyRule.READ).from("SDK 1.3 guide; FHNW report"),
      a -> new Command.EnterSdkMode()),
  TAKEOFF(
      row("takeoff", SDK_1_3).answers("`ok` on arrival").from("FHNW report; DJITelloPy 60"),
      a -> new Command.Takeoff()),
  LAND(
      row("land", SDK_1_3).flight().whileBusy(BusyRule.LAND).from("FHNW report; oh-tello B7"),
      a -> new Command.Land()),
  STREAM_ON(row("streamon", SDK_1_3).from("SDK 2.0 guide"), a -> new Command.Stream(true)),
  STREAM_OFF(row("streamoff", SDK_1_3).from("SDK 2.0 guide"), a -> new Command.Stream(false)),
  EMERGENCY(
      row("emergency", SDK_1_3)
          .whileBusy(BusyRule.ALLOWED)
          .answers("none")
          .from("FHNW report; Tello-Python 85"),
      a -> new Command.Emergency()),
  STOP(
      row("stop", SDK_2_0)
          .whileBusy(BusyRule.ALLOWED)
          .answers("`ok` at once, `forced stop` when the drone stands still")
          .from("FHNW report; tello-asyncio 13"),
      a -> new Command.Stop()),
  UP(move("up"), a -> new Command.Move(Direction.UP, a.meters(0))),
  DOWN(move("down"), a -> new Command.Move(Direction.DOWN, a.meters(0))),
  LEFT(move("left"), a -> new Command.Move(Direction.LEFT, a.meters(0))),
  RIGHT(move("right"), a -> new Command.Move(Direction.RIGHT, a.meters(0))),
  FORWARD(move("forward"), a -> new Command.Move(Direction.FORWARD, a.meters(0))),
  BACK(move("back"), a -> new Command.Move(Direction.BACK, a.meters(0))),
  CW(turn("cw"), a -> new Command.Turn(a.heading(0))),
  CCW(turn("ccw"), a -> new Command.Turn(-a.heading(0))),
  FLIP(
      row("flip", SDK_1_3)
          .with(choice(named("direction", Phrase.of("the direction")), Arguments.flips()))
          .flight()
          .from("FHNW report; DJITelloPy 224"),
      a -> new Command.Flip(a.flip(0))),
  GO(
      row("go", SDK_1_3)
          .with(cm("x"), cm("y"), cm("z"), speed("speed"))
          .flight()
          .rule(CUBE, (a, profile) -> GeometryRules.go(a))
          .from("FHNW report; DJITelloPy 191, 236"),
      a -> new Command.Go(a.point(0), a.meters(3))),
  GO_TO_PAD(
      row("go", SDK_2_0)
          .with(cm("x"), cm("y"), cm("z"), speed("speed"), pad("mid"))
          .flight()
          .rule(CUBE + "; profile `tt`: z from 0", GeometryRules::goToPad)
          .from("SDK 2.0 and 3.0 guides; tello-asyncio 4"),
      a -> new Command.GoToPad(a.point(0), a.meters(3), a.pad(4))),
  CURVE(
      row("curve", SDK_1_3)
          .with(cm("x1"), cm("y1"), cm("z1"), cm("x2"), cm("y2"), cm("z2"), curveSpeed())
          .flight()
          .rule(CUBE + "; radius 0.5 to 10 m", (a, profile) -> GeometryRules.curve(a))
          .from("FHNW report; SDK 2.0 guide"),
      a -> new Command.Curve(GeometryRules.arc(a), a.meters(6))),
  CURVE_OVER_PAD(
      row("curve", SDK_2_0)
          .with(
              cm("x1"), cm("y1"), cm("z1"), cm("x2"), cm("y2"), cm("z2"), curveSpeed(), pad("mid"))
          .flight()
          .rule(CUBE + "; profile `tt`: z1 and z2 from 0", GeometryRules::curveOverPad)
          .from("SDK 2.0 and 3.0 guides; pad guides"),
      a -> new Command.CurveOverPad(a.point(0), a.point(3), a.meters(6), a.pad(7))),
  JUMP(
      row("jump", SDK_2_0)
          .with(cm("x"), cm("y"), cm("z"), speed("speed"), angle("yaw"), pad("mid1"), pad("mid2"))
          .flight()
          .rule("profile `tt`: z above 0", GeometryRules::jump)
          .from("SDK 2.0 and 3.0 guides; pad guides"),
      a ->
          new Command.Jump(
              new Command.GoToPad(a.point(0), a.meters(3), a.pad(5)),
              StrictMath.toRadians(a.number(4)), // in a pad's frame, as in the RoboMaster SDK
              a.pad(6))),
  SPEED(
      row("speed", SDK_1_3).with(speed("x")).from("FHNW report; decided"),
      a -> new Command.SetSpeed(a.meters(0))),
  RC(
      row("rc", SDK_1_3)
          .with(stick("a"), stick("b"), stick("c"), stick("d"))
          .whileBusy(BusyRule.ALLOWED)
          .outOfRange(Reply.OUT_OF_RANGE)
          .answers("none")
          .from("FHNW report"),
      a -> new Command.Rc(new Sticks(a.number(0), a.number(1), a.number(2), a.number(3)))),
  WIFI(
      row("wifi", SDK_1_3)
          .with(word("ssid"), word("password"))
          .from("SDK 2.0 guide; decided for a simulator"),
      a -> new Command.SetNetwork(Reply.OK)),
  MON(row("mon", SDK_2_0).from("SDK 2.0 guide"), a -> new Command.DetectPads(true)),
  MOFF(row("moff", SDK_2_0).from("SDK 2.0 guide"), a -> new Command.DetectPads(false)),
  MDIRECTION(
      row("mdirection", SDK_2_0)
          .with(whole(named("x", Phrase.of("the direction")), 0, 2))
          .from("SDK 2.0 guide"),
      a -> new Command.SetPadDirection(a.integer(0))),
  AP(
      row("ap", SDK_2_0)
          .with(word("ssid"), word("password"))
          .answers("`ok`; behaviour `measured`: `OK,drone will reboot in 3s`")
          .from("jtS3Helper notes; decided for a simulator"),
      a -> new Command.SetNetwork(Reply.WILL_REBOOT)),
  READ_SPEED(read("speed?", SDK_1_3, "`100.0`, cm/s"), readOf(Reading.SPEED)),
  READ_BATTERY(read("battery?", SDK_1_3, "`76`, percent"), readOf(Reading.BATTERY)),
  READ_TIME(read("time?", SDK_1_3, "`24s`, motor time since power-on"), readOf(Reading.TIME)),
  READ_WIFI(read("wifi?", SDK_1_3, "`90`, signal to noise"), readOf(Reading.WIFI)),
  READ_SDK(read("sdk?", SDK_2_0, "`20`; profile `tt`: `30`"), readOf(Reading.SDK)),
  READ_SERIAL(
      row("sn?", SDK_2_0)
          .whileBusy(BusyRule.READ)
          .answers("`0TQSIMUL000001`, 14 bytes, no line end")
          .from("FHNW report; Multi-Tello-Formation 5"),
      readOf(Reading.SERIAL_NUMBER)),
  READ_HEIGHT(read("height?", SDK_1_3, "`15dm`"), readOf(Reading.HEIGHT)),
  READ_TEMPERATURE(read("temp?", SDK_1_3, "`85~88C`"), readOf(Reading.TEMPERATURE)),
  READ_ATTITUDE(read("attitude?", SDK_1_3, "`pitch:0;roll:-1;yaw:0;`"), readOf(Reading.ATTITUDE)),
  READ_BAROMETER(read("baro?", SDK_1_3, "`-102.865509`, m"), readOf(Reading.BAROMETER)),
  READ_ACCELERATION(
      read("acceleration?", SDK_1_3, "`agx:-5.00;agy:7.00;agz:-999.00;`, 0.001 g"),
      readOf(Reading.ACCELERATION)),
  READ_TOF(read("tof?", SDK_1_3, "`875mm`"), readOf(Reading.TOF)),
  READ_PAD(read("mid?", SDK_2_0, "`-1`, the pad's id"), readOf(Reading.PAD)),
  MOTOR_ON(row("motoron", SDK_3_0).from("SDK 3.0 guide"), a -> new Command.SpinMotors(true)),
  MOTOR_OFF(row("motoroff", SDK_3_0).from("SDK 3.0 guide"), a -> new Command.SpinMotors(false)),
  THROW_FLY(
      row("throwfly", SDK_3_0).answers("`ok` on arrival").from("SDK 3.0 guide"),
      a -> new Command.Takeoff()),
  REBOOT(row("reboot", SDK_3_0).answers("none").from("SDK 3.0 guide"), a -> new Command.Reboot()),
  WIFI_CHANNEL(
      row("wifisetchannel", SDK_3_0)
          .with(whole(named("channel", Phrase.of("the channel")), 1, 14))
          .answers("`ok`; behaviour `measured`: `OK,drone will reboot in 3s`")
          .from("SDK 3.0 guide; decided for a simulator"),
      a -> new Command.SetNetwork(Reply.WILL_REBOOT)),
  PORT(
      row("port", SDK_3_0)
          .with(whole("state", 1025, 65535), whole("video", 1025, 65535))
          .from("SDK 3.0 guide; DJITelloPy 150"),
      a -> new Command.SetPorts(a.integer(0), a.integer(1))),
  SET_FPS(
      row("setfps", SDK_3_0)
          .with(choice(named("x", Phrase.of("the frame rate")), "high", "middle", "low"))
          .from("SDK 3.0 guide"),
      a -> new Command.SetVideo(VideoOption.FRAMES_PER_SECOND, a.framesPerSecond(0))),
  SET_BIT_RATE(
      row("setbitrate", SDK_3_0)
          .with(whole(named("n", Phrase.of("the bit rate")), 0, 5))
          .from("SDK 3.0 guide; DJITelloPy 144"),
      a -> new Command.SetVideo(VideoOption.BIT_RATE, a.integer(0))),
  SET_RESOLUTION(
      row("setresolution", SDK_3_0)
          .with(choice(named("x", Phrase.of("the resolution")), "high", "low"))
          .from("SDK 3.0 guide"),
      a -> new Command.SetVideo(VideoOption.LINES, a.lines(0))),
  MULTI_WIFI(
      row("multiwifi", SDK_3_0).with(word("ssid"), word("password")).from("SDK 3.0 guide"),
      acknowledge("ok")),
  DOWN_VISION(
      row("downvision", SDK_3_0)
          .with(whole(named("x", Phrase.of("the camera")), 0, 1))
          .from("DJITelloPy 92, 140, 213"),
      a -> new Command.SetVideo(VideoOption.DOWNWARD, a.integer(0))),
  KEEP_ALIVE(row("keepalive", SDK_3_0).from("DJITelloPy 92"), acknowledge("ok")),
  READ_ACTIVATION(
      row("active?", SDK_3_0).whileBusy(BusyRule.READ).from("DJITelloPy 92"),
      readOf(Reading.ACTIVATION)),
  READ_HARDWARE(read("hardware?", SDK_3_0, "`RMTT`"), readOf(Reading.HARDWARE)),
  READ_WIFI_VERSION(read("wifiversion?", SDK_3_0, "`wifiv1.0.0.0`"), readOf(Reading.WIFI_VERSION)),
  READ_AP(read("ap?", SDK_3_0, "name and password, here none"), readOf(Reading.JOINED_NETWORK)),
  READ_SSID(read("ssid?", SDK_3_0, "own name and password"), readOf(Reading.OWN_NETWORK)),
  BOARD_LED(
      board("EXT led", "led").with(rgb("r"), rgb("g"), rgb("b")),
      a -> lamp(LampEffect.steady(a.rgb(0)))),
  BOARD_LED_BREATHE(
      board("EXT led br", "led").with(hertz(), rgb("r"), rgb("g"), rgb("b")),
      a -> lamp(LampEffect.breathing(a.number(0), a.rgb(1)))),
  BOARD_LED_BLINK(
      board("EXT led bl", "led")
          .with(hertz(), rgb("r1"), rgb("g1"), rgb("b1"), rgb("r2"), rgb("g2"), rgb("b2")),
      a -> lamp(LampEffect.blinking(a.number(0), a.rgb(1), a.rgb(4)))),
  BOARD_MATRIX(
      board("EXT mled g", "matrix").with(word("pattern")),
      a -> matrix(MatrixEffect.still(MatrixPicture.ofPattern(a.word(0))))),
  BOARD_MATRIX_MOVE(
      board("EXT mled", "matrix")
          .with(choice("direction", "l", "r", "u", "d"), color(), hertz(), text("text")),
      a -> matrix(MatrixEffect.text(a.word(3), a.dotColor(1), a.move(0), a.number(2)))),
  BOARD_MATRIX_CHARACTER(
      board("EXT mled s", "matrix").with(color(), word("character")),
      a -> matrix(MatrixEffect.still(a.character(1, a.dotColor(0))))),
  BOARD_MATRIX_BOOT(
      board("EXT mled sg", "matrix").with(word("pattern")),
      a -> dots(new LightOrder.Greet(MatrixPicture.ofPattern(a.word(0))))),
  BOARD_MATRIX_CLEAR(
      board("EXT mled sc", "matrix"), a -> dots(new LightOrder.Greet(MatrixPicture.DARK))),
  BOARD_MATRIX_LIGHT(
      board("EXT mled sl", "matrix").with(whole(named("n", Phrase.of("the brightness")), 0, 255)),
      a -> dots(new LightOrder.Dim(a.integer(0)))),
  BOARD_TOF(
      row("EXT tof?", SDK_3_0)
          .whileBusy(BusyRule.READ)
          .answers("`tof 875`, mm; `tof 8192` out of range")
          .from("SDK 3.0 guide"),
      readOf(Reading.BOARD_TOF)),
  BOARD_VERSION(
      row("EXT version?", SDK_3_0)
          .whileBusy(BusyRule.READ)
          .answers("`esp32v1.0.0.0`")
          .from("SDK 3.0 guide"),
      readOf(Reading.BOARD_VERSION));

  /** The first words of all commands of all products. */
  static final Set<String> FIRST_WORDS =
      Stream.of(values()).map(CommandSyntax::firstWord).collect(Collectors.toUnmodifiableSet());

  private final Row row;
  private final String verb;
  private final Function<Arguments, Command> record;

  CommandSyntax(Row row, Function<Arguments, Command> record) {
    this.row = row;
    this.verb = String.join(" ", row.verbWords());
    this.record = record;
  }

  /** Returns the form and the limits of the command. */
  Row form() {
    return row;
  }

  /** Returns the first word of the verb. */
  String firstWord() {
    return row.verbWords().get(0);
  }

  /** Returns the fixed words at the beginning of the command. */
  public String verb() {
    return verb;
  }

  /** Returns the SDK that introduced the command. */
  public Sdk since() {
    return row.since();
  }

  /** Whether the command is a read command or {@code command}, so that any host may send it. */
  boolean readOnly() {
    return this == COMMAND || verb.endsWith("?");
  }

  /** Returns the rule for the command while another one runs. */
  public BusyRule busyRule() {
    return row.traits().busy();
  }

  /** Whether the command requires an airborne drone. */
  public boolean needsFlight() {
    return row.traits().flight();
  }

  /** Describes the reply when the command succeeds. */
  public String success() {
    return row.success();
  }

  /** Describes the source of the command's behaviour. */
  public String source() {
    return row.source();
  }

  /** Returns the command's syntax, with the names of its parameters. */
  public String usage() {
    StringBuilder usage = new StringBuilder(verb);
    row.parameters().forEach(parameter -> usage.append(' ').append(parameter.name().symbol()));
    return usage.toString();
  }

  /**
   * Describes the parameters and their ranges. Adjacent parameters with equal ranges share one
   * description.
   */
  public String ranges() {
    return row.ranges();
  }

  /** Whether the command's values can be out of range. */
  public boolean limited() {
    return row.limited();
  }

  /** Returns the reply when a parameter is out of range. */
  public Reply outOfRange() {
    return row.traits().outOfRange();
  }

  boolean knownTo(Profile profile) {
    return profile.knows(row.since());
  }

  /** Creates the command from valid values. */
  Command command(Arguments arguments) {
    return record.apply(arguments);
  }

  private static Function<Arguments, Command> readOf(Reading reading) {
    return a -> new Command.Read(reading);
  }

  private static Command lamp(LampEffect effect) {
    return new Command.Light(new LightOrder.Shine(effect), new Reply("led ok"));
  }

  private static Command matrix(MatrixEffect effect) {
    return dots(new LightOrder.Show(effect));
  }

  private static Command dots(LightOrder order) {
    return new Command.Light(order, new Reply("matrix ok"));
  }

  private static Function<Arguments, Command> acknowledge(String reply) {
    return a -> new Command.Acknowledge(new Reply(reply));
  }
}
