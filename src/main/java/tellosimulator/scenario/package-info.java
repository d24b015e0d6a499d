/**
 * Reads and writes scenario files in YAML.
 *
 * <p>{@link tellosimulator.scenario.ScenarioFile} reads a {@link tellosimulator.scenario.Scenario},
 * or throws a {@link tellosimulator.scenario.ScenarioException} with all errors in the file and
 * their positions. It also writes scenarios. Each key is declared once, as a {@code Field} of a
 * {@code RecordCodec}. This declaration determines how the key is read, written, limited and
 * described to editors. {@link tellosimulator.scenario.ScenarioDocument} preserves the text of a
 * file when its scenario changes. It converts the previous and the new scenario to nodes with all
 * keys. A {@code ScenarioPatch} then puts the items that differ into the {@code SourceLayout} of
 * the text. {@link tellosimulator.scenario.Gallery} contains the scenarios that come with the
 * program. All public types are immutable. The package imports {@code goal}, {@code network} and
 * the packages below them. The package neither runs scenarios nor judges flights.
 */
package tellosimulator.scenario;
