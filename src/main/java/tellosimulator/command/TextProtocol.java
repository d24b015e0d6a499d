package tellosimulator.command;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** The text protocol of the SDK: commands, replies, and state lines. */
public final class TextProtocol implements DroneProtocol {

  /** First byte of the app's binary protocol. Measured: TelloPy 50. */
  private static final byte APP_PACKET = (byte) 0xcc;

  /** The app's connection request. Measured: TelloPy 50. */
  private static final byte[] APP_REQUEST = "conn_req".getBytes(StandardCharsets.ISO_8859_1);

  private final ProtocolContext drone;
  private final CommandHandler handler;
  private final StateLines stateLines;

  public TextProtocol(ProtocolContext drone) {
    this.drone = drone;
    stateLines = new StateLines(drone);
    CommandHandler.Ends ends =
        new CommandHandler.Ends(drone.session(), drone.port(), drone.observer());
    DroneCommands commands = new DroneCommands(drone, stateLines);
    handler = new CommandHandler(drone.profile(), drone.behavior(), commands, ends);
  }

  @Override
  public boolean claims(byte[] datagram) {
    boolean packet = datagram.length > 0 && datagram[0] == APP_PACKET;
    int start = Arrays.mismatch(datagram, APP_REQUEST);
    return !packet && start >= 0 && start < APP_REQUEST.length;
  }

  @Override
  public void receive(Peer peer, byte[] datagram) {
    handler.handle(peer, WireText.decode(datagram), drone.now());
    stateLines.owe();
  }

  @Override
  public void output() {
    stateLines.send();
  }

  @Override
  public boolean hasPending() {
    return stateLines.hasPending();
  }

  @Override
  public void reset() {
    handler.forgetCopies();
  }

  @Override
  public void powerOff() {
    handler.forgetCopies();
    stateLines.end();
  }
}
