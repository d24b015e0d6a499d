package tellosimulator.view.pilot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import tellosimulator.model.FlightPhase;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;

/**
 * Sends single commands to the selected drone through its real port, without waiting for replies; a
 * refusal becomes a sentence. For the JavaFX thread; it moves on with the pulse.
 */
final class RemoteControl implements AutoCloseable {

  private final ViewContext context;
  private final ReadOnlyObjectWrapper<Message> problem = new ReadOnlyObjectWrapper<>(Message.NONE);
  private Optional<OperatorSocket> socket = Optional.empty();
  private String asked = "";

  /**
   * Counts what was asked for, so that a takeoff that waits for power gives way to what is next.
   */
  private int asks;

  public RemoteControl(ViewContext context) {
    this.context = context;
    context.pulse().onBeat(nanos -> beat());
  }

  /** Takes off; switches the drone on first, if it is off. */
  void takeOff() {
    problem.set(Message.NONE);
    if (!drone().onProperty().get()) {
      FxDroneModel drone = drone();
      asks++;
      int mine = asks;
      context
          .actions()
          .switchPower(
              drone.number(),
              true,
              refusal ->
                  refusal.ifPresentOrElse(
                      e -> problem.set(OperatorClient.portTaken(e)),
                      () -> {
                        if (mine == asks) {
                          ask(drone, "takeoff");
                        }
                      }));
    } else {
      ask("takeoff");
    }
  }

  /** Takes off, or lands what flies. */
  void takeOffOrLand() {
    if (phase().flying()) {
      ask("land");
    } else {
      takeOff();
    }
  }

  /** Sends a command that is answered. */
  void ask(String command) {
    ask(drone(), command);
  }

  private void ask(FxDroneModel drone, String command) {
    asks++;
    asked = command;
    problem.set(Message.NONE);
    send(drone, command);
  }

  /** Sends a command that has no answer, such as {@code rc}. */
  void tell(String command) {
    send(drone(), command);
  }

  /** The same to a drone that need not be the selected one. */
  void tell(FxDroneModel drone, String command) {
    send(drone, command);
  }

  /** What the selected drone is doing. */
  FlightPhase phase() {
    return drone().phaseProperty().get();
  }

  /** What was refused last; {@link Message#NONE} after a command that succeeded. */
  ReadOnlyObjectProperty<Message> problemProperty() {
    return problem.getReadOnlyProperty();
  }

  /** Something else is being done; what was refused before is old news. */
  void forgetProblem() {
    problem.set(Message.NONE);
  }

  @Override
  public void close() {
    socket.ifPresent(OperatorSocket::close);
    socket = Optional.empty();
  }

  private FxDroneModel drone() {
    return context.simulation().selected();
  }

  private void send(FxDroneModel drone, String command) {
    try {
      OperatorSocket operator = socket(drone);
      if (drone.operatorProperty().get().isEmpty()) {
        operator.send("command");
      }
      operator.send(command);
    } catch (IOException e) {
      lost();
    }
  }

  private OperatorSocket socket(FxDroneModel drone) throws IOException {
    InetSocketAddress address = context.actions().addresses(drone.number()).get(0);
    if (socket.isEmpty() || !socket.get().drone().equals(address)) {
      close();
      socket = Optional.of(OperatorSocket.open(address));
    }
    return socket.get();
  }

  private void beat() {
    try {
      while (socket.isPresent()) {
        Optional<String> reply = socket.get().receive();
        if (reply.isEmpty()) {
          return;
        }
        judge(reply.get());
      }
    } catch (IOException e) {
      lost();
    }
  }

  private void judge(String reply) {
    if (reply.startsWith("error") || reply.startsWith("unknown command")) {
      problem.set(OperatorClient.refused(asked, reply));
    }
  }

  private void lost() {
    close();
    if (drone().onProperty().get()) {
      int port = context.actions().addresses(drone().number()).get(0).getPort();
      problem.set(
          Message.of("unreachable", Integer.toString(drone().number()), Integer.toString(port)));
    }
  }
}
