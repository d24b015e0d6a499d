package tellosimulator.command;

/** The text protocol of the SDK: commands, replies, and state lines. */
public final class TextProtocol implements DroneProtocol {

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

  /** Claims everything, because any bytes are a text. The drone's other protocols come first. */
  @Override
  public boolean claims(byte[] datagram) {
    return true;
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
