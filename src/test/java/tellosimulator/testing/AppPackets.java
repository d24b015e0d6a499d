package tellosimulator.testing;

import java.util.HexFormat;
import tellosimulator.command.WireText;

/**
 * Datagrams of the app's protocol for tests outside its package, one character per byte; checksums
 * were computed by another program.
 */
public final class AppPackets {

  public static final String CONNECT = "conn_req:\u0096\u0017";
  public static final String ACKNOWLEDGEMENT = "conn_ack:\u0096\u0017";

  public static final String TAKEOFF = text("cc58007c68540001006a90");
  public static final String TAKEOFF_DONE = text("cc600027b054000100007ddb");
  public static final String TAKEOFF_REFUSED = text("cc600027b05400010001f4ca");
  public static final String LAND = text("cc600027685500020000c65b");
  public static final String LAND_DONE = text("cc600027b055000200005d3f");
  public static final String STOP_LANDING = text("cc6000276855000300019310");
  public static final String FLIP_BACK = text("cc600027705c00040002819c");
  public static final String HEIGHT_LIMIT_10 = text("cc68005168580005000a000ec0");
  public static final String SSID = text("cc58007c4811000700cbdc");
  public static final String KEY_PICTURE = text("cc58007c60250000006c95");
  public static final String FLIGHT_DATA =
      text("cc1801b988560009000000000000000000000000000000000000000000000000006332");

  /** Sticks forward by 50, and fully counterclockwise. */
  public static final String STICKS = text("ccb0007f605000000000542a00d902000000000033da");

  private AppPackets() {}

  private static String text(String hex) {
    return WireText.decode(HexFormat.of().parseHex(hex));
  }
}
