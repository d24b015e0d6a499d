package tellosimulator.view.replay;

import atlantafx.base.theme.Styles;
import java.util.Optional;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;
import javafx.scene.shape.Circle;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.fx.FxTextures;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * Shows the names of the flight and its ghost, remarks on missing parts of their recordings, and a
 * menu that selects another ghost. Confined to the JavaFX thread.
 */
final class ComparisonPanel extends VBox {

  private static final double DOT = 5;

  private final FxReplay replay;
  private final GhostLoader ghosts;
  private final Language language;
  private final Messages messages;
  private final Label flight = Nodes.sentence("flight-name");
  private final Label ghost = Nodes.sentence("ghost-name");
  private final Label remarks = Nodes.sentence("remarks", "remarks");
  private final Label news = Nodes.sentence("ghost-news");
  private final MenuButton compare = Nodes.named(new MenuButton(), "compare", Styles.SMALL);

  ComparisonPanel(FxReplay replay, GhostLoader ghosts, Language language) {
    this.replay = replay;
    this.ghosts = ghosts;
    this.language = language;
    messages = language.messages(ComparisonPanel.class);
    initializeParts();
    setupBindings();
    getStyleClass().add("comparison");
    getChildren().addAll(flight, ghost, remarks, news, compare);
  }

  private void initializeParts() {
    compare.setGraphic(new FontIcon(Feather.COPY));
    compare.textProperty().bind(messages.text("compare"));
    Tooltips.install(compare, messages.text("compare.tooltip"));
    MenuItem other = item("compare-other", () -> ghosts.choose(getScene().getWindow()));
    MenuItem again = item("compare-again", ghosts::flyAgain);
    MenuItem none = item("compare-none", ghosts::remove);
    none.disableProperty().bind(replay.ghostProperty().map(Optional::isEmpty));
    compare.getItems().setAll(other, again, none);
  }

  private MenuItem item(String id, Runnable action) {
    return Nodes.menuItem(new MenuItem(), id, messages.text(id), action);
  }

  private void setupBindings() {
    flight.textProperty().bind(messages.text("flight-name", replay.flight().name()));
    replay
        .simulation()
        .selectedProperty()
        .subscribe(drone -> flight.setGraphic(dot(DroneColors.of(drone))));
    ghost.setGraphic(dot(FxTextures.color(Rgb.of(FxReplay.GHOST_RGB))));
    ghost
        .textProperty()
        .bind(
            replay
                .ghostProperty()
                .flatMap(
                    other ->
                        other
                            .map(there -> messages.text("ghost-name", there.name()))
                            .orElseGet(() -> messages.text("nothing"))));
    language.localeProperty().subscribe(locale -> writeRemarks());
    replay.ghostProperty().subscribe(other -> writeRemarks());
    news.textProperty().bind(replay.newsProperty());
  }

  private static Circle dot(Color color) {
    return new Circle(DOT, color);
  }

  private void writeRemarks() {
    StringBuilder text = new StringBuilder();
    add(text, "remark-on-flight", replay.flight());
    replay.ghostProperty().get().ifPresent(other -> add(text, "remark-on-ghost", other));
    remarks.setText(text.toString().strip());
  }

  private void add(StringBuilder text, String key, ReplayFlight about) {
    about
        .flight()
        .remarks()
        .forEach(remark -> text.append(messages.now(key, language.say(remark))).append('\n'));
  }
}
