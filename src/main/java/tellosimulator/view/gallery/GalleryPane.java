package tellosimulator.view.gallery;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javafx.geometry.Orientation;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The scenarios that come with the program as cards, and below them the files that were open last.
 * For the JavaFX thread.
 */
public final class GalleryPane extends VBox {

  /**
   * What there is to choose from, beside the scenarios of the program; stays when the scenario
   * changes.
   */
  public record Offer(RoomPictures pictures, RecentFiles recent, SolvedScenarios solved) {}

  /**
   * What is done with what was chosen.
   *
   * @param known opens a scenario of the program by its short name
   * @param file opens a file
   */
  public record OptionValue(Consumer<String> known, Consumer<Path> file) {}

  private final List<ScenarioCard> cards = new ArrayList<>();

  public GalleryPane(Language language, Offer offer, OptionValue choice) {
    setId("gallery");
    getStyleClass().add("gallery");
    getStylesheets().add(GalleryPane.class.getResource("gallery.css").toExternalForm());
    for (String name : Gallery.NAMES) {
      Gallery.find(name).ifPresent(known -> cards.add(card(language, name, known, choice)));
    }
    for (ScenarioCard card : cards) {
      String name = card.getId().substring("scenario-".length());
      card.picture().imageProperty().bind(offer.pictures().picture(name));
      card.setSolved(offer.solved().contains(name));
    }
    CardGrid grid = new CardGrid(cards);
    ScrollPane scroll = new FittingScrollPane(grid);
    scroll.setFitToWidth(true);
    scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
    VBox.setVgrow(scroll, Priority.ALWAYS);
    getChildren().add(scroll);
    List<Path> recent = offer.recent().filesProperty().getValue();
    if (!recent.isEmpty()) {
      Messages messages = language.messages(GalleryPane.class);
      Label heading = messages.label("recent", "heading");
      getChildren().addAll(heading, new RecentList(language, recent, choice.file()));
    }
  }

  /** As high as its content is in its width, from the first layout on. */
  private static final class FittingScrollPane extends ScrollPane {

    FittingScrollPane(CardGrid grid) {
      super(grid);
    }

    @Override
    public Orientation getContentBias() {
      return Orientation.HORIZONTAL;
    }

    @Override
    protected double computePrefHeight(double width) {
      return width < 0
          ? super.computePrefHeight(width)
          : Math.ceil(getContent().prefHeight(width) + snappedTopInset() + snappedBottomInset());
    }
  }

  private static ScenarioCard card(
      Language language, String name, Scenario scenario, OptionValue choice) {
    ScenarioCard card =
        new ScenarioCard(language, scenario.description(), () -> choice.known().accept(name));
    card.setId("scenario-" + name);
    return card;
  }

  /** What has the focus at first. */
  public Node firstCard() {
    return cards.get(0);
  }
}
