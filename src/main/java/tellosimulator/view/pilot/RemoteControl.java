package tellosimulator.view.pilot;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import tellosimulator.model.FlightPhase;
import tellosimulator.pilot.OperatorSocket;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Message;

/**
 * Sends single commands to the UDP command port of the selected drone, without waiting for replies.
 * The last refusal is available as a property. Confined to the JavaFX thread; advances with the UI
 * ticks.
 */
final class RemoteControl implements AutoCloseable {

  private final ViewContext context;
  private final ReadOnlyObjectWrapper<Message> problem = new ReadOnlyObjectWrapper<>(Message.NONE);
  private Optional<OperatorSocket> socket = Optional.empty();
  private String asked = "";

  /**
   * Number of requests so far. A takeoff that is waiting for the drone to be switched on is
   * superseded by any later request.
   */
  private int asks;

  public RemoteControl(ViewContext context) {
    this.context = context;
    context.ticker().onTick(nanos -> tick());
  }

  /** Takes off, after switching the drone on if necessary. */
  void takeOff() {
    problem.set(Message.NONE);
    FxDroneModel drone = drone();
    if (drone.onProperty().get()) {
      ask("takeoff");
      return;
    }
    asks++;
    int mine = asks;
    OperatorClient.switchOn(
        context,
        drone,
        problem::set,
        () -> {
          if (mine == asks) {
            ask(drone, "takeoff");
          }
        });
  }

  /** Takes off, or lands if the drone is flying. */
  void takeOffOrLand() {
    if (phase().flying()) {
      ask("land");
    } else {
      takeOff();
    }
  }

  /** Sends a command that has a reply. */
  void ask(String command) {
    ask(drone(), command);
  }

  private void ask(FxDroneModel drone, String command) {
    asks++;
    asked = command;
    problem.set(Message.NONE);
    send(drone, command);
  }

  /** Sends a command that has no reply, such as {@code rc}. */
  void tell(String command) {
    send(drone(), command);
  }

  /** Sends a command that has no reply. The drone need not be selected. */
  void tell(FxDroneModel drone, String command) {
    send(drone, command);
  }

  /** Returns the flight phase of the selected drone. */
  FlightPhase phase() {
    return drone().phaseProperty().get();
  }

  /**
   * The reason why the last command was refused or could not be sent; {@link Message#NONE} if there
   * is none.
   */
  ReadOnlyObjectProperty<Message> problemProperty() {
    return problem.getReadOnlyProperty();
  }

  /** Clears the last problem, because another action starts. */
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
      if (drone.snapshotProperty().get().link().operator().isEmpty()) {
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

  private void tick() {
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
