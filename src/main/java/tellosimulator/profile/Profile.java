package tellosimulator.profile;

import java.util.Locale;
import tellosimulator.math.Vec3;

/**
 * The simulated product. It determines which commands the drone knows and which values it reports.
 */
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

  /** Returns the reply to {@code hardware?}. Documented: SDK 3.0 User Guide. */
  public String hardware() {
    return hardware;
  }

  /** Whether the product knows the commands that were introduced with {@code since}. */
  public boolean knows(Sdk since) {
    return sdk.compareTo(since) >= 0;
  }

  /**
   * Whether the product detects mission pads, reports them in the state line and accepts the {@code
   * Re} header. Measured: the state lines of white Tellos begin with {@code pitch}, and the header
   * is a feature of the EDU.
   */
  public boolean hasPads() {
    return this != TELLO;
  }

  /**
   * Returns the value of {@code mpry} while no pad is in sight: pitch, yaw and roll [degrees].
   * Measured: -1 with an EDU (FHNW report 2020, tello-edu-rs); documented: 0 (SDK 3.0 User Guide).
   */
  public Vec3 attitudeWithoutPad() {
    return sdk == Sdk.SDK_3_0 ? Vec3.ZERO : new Vec3(-1, -1, -1);
  }

  /**
   * Whether the drone echoes only the first word of an unknown command, not the whole command.
   * Measured: white Tellos echo the first word (logs in DJITelloPy issues 144 and 219); an EDU
   * echoes the whole command (FHNW report 2020).
   */
  public boolean echoesFirstWord(Behavior behavior) {
    return this == TELLO && behavior == Behavior.MEASURED;
  }

  /** Returns the word that selects this product on the command line. */
  public String option() {
    return name().toLowerCase(Locale.ROOT);
  }
}
