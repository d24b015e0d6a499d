package tellosimulator.view.controls;

import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;

/** What somebody who has no program yet begins with. For the JavaFX thread. */
final class ProgramPanel extends Card {

  /** Time between two looks at the address [ns]. Decided: four a second. */
  private static final long PERIOD_NANOS = 250_000_000;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final FirstProgram program;
  private final DrawingClock clock;

  ProgramPanel(ViewContext context) {
    super("program", context.language().messages(ProgramPanel.class).text("program.heading"));
    simulation = context.simulation();
    actions = context.actions();
    program = new FirstProgram("panel", context.language());
    layoutCard(program);
    layoutHead(program.copyButton());
    clock = new DrawingClock(simulation, PERIOD_NANOS);
    refresh();
    simulation.selectedProperty().subscribe(this::refresh);
    context.pulse().onBeat(this::beat);
  }

  private void beat(long nanos) {
    if (clock.due(nanos) && !actions.pending()) {
      clock.take(nanos);
      refresh();
    }
  }

  private void refresh() {
    program.fly(actions.addresses(simulation.selected().number()));
  }
}
