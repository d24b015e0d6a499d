package tellosimulator.view;

import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import javafx.application.Platform;
import javafx.stage.Stage;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.sim.SimConfig;
import tellosimulator.view.text.Language;

/** The program with a window. */
public final class SimulatorApp implements AutoCloseable {

  private final OnlineSimulation simulation;
  private final CountDownLatch closed = new CountDownLatch(1);

  /**
   * Starts the simulation; all drones are off.
   *
   * @param replyPort port to which all replies go; empty for the port each command came from
   */
  public SimulatorApp(SimConfig config, AddressPlan plan, OptionalInt replyPort) {
    simulation = new OnlineSimulation(config, plan, replyPort, List.of());
  }

  /**
   * Switches all drones on, or none.
   *
   * @throws PortTakenException if an address or port cannot be had
   */
  public void switchAllOn() throws PortTakenException {
    simulation.switchAllOn();
  }

  /** Which drone listens where; see {@link OnlineSimulation#ready}. */
  public String ready() {
    return simulation.ready();
  }

  /** Opens the window, and returns after it was closed. The {@link Toolkit} must run. */
  public void run() throws InterruptedException {
    Platform.runLater(this::open);
    closed.await();
    Platform.exit();
  }

  private void open() {
    Language language = new Language(Locale.getDefault());
    ViewContext context = ViewContext.of(simulation, language);
    Stage stage = new Stage();
    SimulatorWindow window = new SimulatorWindow(stage, context);
    stage.setOnHidden(
        hidden -> {
          window.close();
          closed.countDown();
        });
    context.pulse().start();
    stage.show();
    OpeningSize.hold(stage);
    FirstFrame.report();
  }

  @Override
  public void close() {
    simulation.close();
  }
}
