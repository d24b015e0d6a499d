package tellosimulator.view.controls;

import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.layout.HBox;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.scenario.Quantity;
import tellosimulator.scenery.texture.ImageFile;
import tellosimulator.sim.Control;
import tellosimulator.view.fx.Nodes;
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
 * The panel for rarely changed values: the selected drone's battery, the appearance of the walls,
 * and the settings for a new run. Folded by default. Confined to the JavaFX thread.
 */
final class MorePanel extends Card {

  private static final NumberRange PERCENT = new NumberRange(Quantity.BATTERY_PERCENT, 1);

  /**
   * Height of the middle of a new poster above the floor [m]. Decided: the height at which drones
   * hover.
   */
  private static final double POSTER_HEIGHT = 1;

  /** Width of a new poster [m]. */
  private static final double POSTER_WIDTH = 0.6;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final NumberSlider battery;
  private final SegmentedButton<Walls> walls;
  private final Button hang;
  private final Button takeDown;
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
    hang =
        Nodes.button(
            "poster-hang",
            Feather.IMAGE,
            messages.text("poster.hang"),
            messages.text("poster.hang.hint"));
    takeDown = new Button("", new FontIcon(Feather.TRASH_2));
    Nodes.described(Nodes.named(takeDown, "poster-take-down"), messages.text("poster.take-down"));
    layoutParts(new StartPanel(context));
    hang.setOnAction(pressed -> choosePoster());
    takeDown.setOnAction(pressed -> takeDown());
    simulation.selectedProperty().addListener(changed -> battery.forgetTyped());
    context.ticker().onTick(nanos -> beat());
    foldingProperty().set(Folding.FOLDED);
  }

  private SegmentedButton.Option<Walls> walls(Walls value) {
    String id = value.name().toLowerCase(Locale.ROOT);
    return SegmentedButton.Option.of(messages, "walls", value, id);
  }

  private void layoutParts(StartPanel start) {
    HBox posters = Nodes.styled(new HBox(Nodes.growing(hang), takeDown), "row");
    layoutCard(battery, walls, posters, diagnostic, start);
  }

  /**
   * Sends a change if there is one, and otherwise shows the current values. The display is not
   * updated while actions are pending, because the values are then outdated.
   */
  private void beat() {
    NumberSlider.advance(
        actions,
        () -> new Control.SetBattery(simulation.selected().number(), battery.value()),
        this::show,
        battery);
  }

  private void show() {
    battery.show(Math.rint(simulation.selected().batteryPercentProperty().get()));
    walls.show(decor().walls());
    takeDown.setDisable(decor().posters().isEmpty());
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

  /** Hangs an image on the front wall as a poster, in front of earlier posters. */
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

  /** Removes the latest poster. */
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
