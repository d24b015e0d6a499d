package tellosimulator.view.controls;

import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.scenery.texture.ImageFile;
import tellosimulator.sim.Control;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Message;
import tellosimulator.view.text.Messages;
import tellosimulator.world.Decor;
import tellosimulator.world.Poster;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;

/**
 * What one seldom changes: the selected drone's battery, the looks of the walls, and what a flight
 * begins with. Folded until somebody wants it. For the JavaFX thread.
 */
final class MorePanel extends Card {

  private static final NumberRange PERCENT = new NumberRange(0, 100, 1);

  /** Where a new poster hangs, and how wide it is [m]. Decided: as high as drones hover. */
  private static final double POSTER_HEIGHT = 1;

  private static final double POSTER_WIDTH = 0.6;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final NumberSlider battery;
  private final SegmentedButton<Walls> walls;
  private final Button hang = new Button("", new FontIcon(Feather.IMAGE));
  private final Button takeDown = new Button("", new FontIcon(Feather.TRASH_2));
  private final MessageLabel diagnostic;

  MorePanel(ViewContext context) {
    super("more", context.language().messages(MorePanel.class).text("more"));
    simulation = context.simulation();
    actions = context.actions();
    Language language = context.language();
    messages = language.messages(MorePanel.class);
    battery = new NumberSlider("battery-level", messages.text("battery-level"), PERCENT, language);
    walls =
        new SegmentedButton<>(
            "walls",
            List.of(walls(Walls.AUTO), walls(Walls.TEXTURED), walls(Walls.PLAIN)),
            this::paper);
    diagnostic = new MessageLabel(messages, "poster-error", "danger");
    initializeParts();
    layoutParts(new StartPanel(context));
    setupEventHandlers();
    context.pulse().onBeat(nanos -> beat());
    foldingProperty().set(Folding.FOLDED);
  }

  private SegmentedButton.Option<Walls> walls(Walls value) {
    String key = "walls." + value.name().toLowerCase(Locale.ROOT);
    return new SegmentedButton.Option<>(
        value,
        value.name().toLowerCase(Locale.ROOT),
        messages.text(key),
        messages.text(key + ".hint"));
  }

  private void initializeParts() {
    hang.setId("poster-hang");
    hang.textProperty().bind(messages.text("poster.hang"));
    hang.setMaxWidth(Double.MAX_VALUE);
    Tooltips.install(hang, messages.text("poster.hang.hint"));
    takeDown.setId("poster-take-down");
    takeDown.accessibleTextProperty().bind(messages.text("poster.take-down"));
    Tooltips.install(takeDown, messages.text("poster.take-down"));
  }

  private void layoutParts(StartPanel start) {
    HBox.setHgrow(hang, Priority.ALWAYS);
    HBox posters = new HBox(hang, takeDown);
    posters.getStyleClass().add("row");
    layoutCard(battery, walls, posters, diagnostic, start);
  }

  private void setupEventHandlers() {
    hang.setOnAction(pressed -> choosePoster());
    takeDown.setOnAction(pressed -> takeDown());
    simulation.selectedProperty().addListener(changed -> battery.forgetTyped());
  }

  /** What the simulation does not have yet is not shown as it was before. */
  private void beat() {
    if (battery.takeChange()) {
      actions.carryOut(new Control.SetBattery(simulation.selected().number(), battery.value()));
    } else if (!actions.pending()) {
      battery.show(Math.rint(simulation.selected().batteryPercentProperty().get()));
      walls.show(decor().walls());
      takeDown.setDisable(decor().posters().isEmpty());
    }
  }

  private void paper(Walls wanted) {
    actions.carryOut(new Control.Decorate(decor().withWalls(wanted)));
  }

  private void choosePoster() {
    FileChooser chooser = new FileChooser();
    chooser.setTitle(messages.now("poster.hang"));
    chooser
        .getExtensionFilters()
        .setAll(
            new ExtensionFilter(
                messages.now("poster.files"), "*.png", "*.jpg", "*.jpeg", "*.gif", "*.bmp"));
    Optional.ofNullable(chooser.showOpenDialog(getScene().getWindow()))
        .map(File::getPath)
        .ifPresent(this::hang);
  }

  /** Hangs an image on the front wall, in front of those that hang there. */
  void hang(String picture) {
    try {
      ImageFile.check(picture);
    } catch (IOException e) {
      diagnostic.say(Optional.of(Message.of("poster.unreadable", picture)));
      return;
    }
    diagnostic.say(Optional.empty());
    List<Poster> posters = new ArrayList<>(decor().posters());
    posters.add(new Poster(Surface.FRONT_WALL, 0, POSTER_HEIGHT, POSTER_WIDTH, picture));
    actions.carryOut(new Control.Decorate(decor().withPosters(posters)));
  }

  /** Takes down the one that was hung last. */
  private void takeDown() {
    List<Poster> posters = decor().posters();
    if (!posters.isEmpty()) {
      actions.carryOut(
          new Control.Decorate(decor().withPosters(posters.subList(0, posters.size() - 1))));
    }
  }

  private Decor decor() {
    return simulation.decorProperty().get();
  }
}
