/**
 * What is handed out, and the files that hand it out.
 *
 * <p>{@code ReleaseFilesTest} compares versions and names in the repository's files with those of
 * {@code pom.xml}. {@code LicensesIT} and {@code AllSystemsIT} look into the programs that Maven
 * has built, and run in its {@code verify}. It may import {@code json}, and no other package of the
 * simulator.
 */
package tellosimulator.release;
