package tellosimulator.profile;

import java.util.Locale;
import tellosimulator.math.Vec3;

/** Which product is simulated; a client sees the difference in what is known and reported. */
public enum Profile {
  /** Tello EDU, firmware 02.04: SDK 2.0, mission pads, retransmission header. */
  EDU(Sdk.SDK_2_0, "TELLO"),
  /** White Tello, firmware 01.04: SDK 1.3, no pads. */
  TELLO(Sdk.SDK_1_3, "TELLO"),
  /** RoboMaster TT, the EDU's successor with the extension board: SDK 3.0. */
  TT(Sdk.SDK_3_0, "RMTT");

  private final Sdk sdk;
  private final String hardware;

  Profile(Sdk sdk, String hardware) {
    this.sdk = sdk;
    this.hardware = hardware;
  }

  public Sdk sdk() {
    return sdk;
  }

  /** Reply to {@code hardware?}. Documented: SDK 3.0 User Guide. */
  public String hardware() {
    return hardware;
  }

  /** Whether commands that came with {@code since} are known. */
  public boolean knows(Sdk since) {
    return sdk.compareTo(since) >= 0;
  }

  /**
   * Whether it sees mission pads, reports them in the state line and takes the {@code Re} header.
   * Measured: state lines of white Tellos begin with {@code pitch}; the header is the EDU's.
   */
  public boolean hasPads() {
    return this != TELLO;
  }

  /**
   * What {@code mpry} says without a pad: pitch, yaw and roll [degrees]. Measured: -1 with an EDU
   * (FHNW report 2020, tello-edu-rs); documented: 0 (SDK 3.0 User Guide).
   */
  public Vec3 attitudeWithoutPad() {
    return sdk == Sdk.SDK_3_0 ? Vec3.ZERO : new Vec3(-1, -1, -1);
  }

  /**
   * Whether an unknown command is echoed by its first word only, rather than whole. Measured: logs
   * of white Tellos (DJITelloPy issues 144 and 219); of an EDU: FHNW report 2020.
   */
  public boolean echoesFirstWord(Behavior behavior) {
    return this == TELLO && behavior == Behavior.MEASURED;
  }

  /** The word that chooses it on the command line. */
  public String option() {
    return name().toLowerCase(Locale.ROOT);
  }
}
