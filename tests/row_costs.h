/* row_costs.h - the time of each of the 240 rows of the gallery's scenes, 320x240, as measured with one thread: a
 * character a row, 1.15^(character - '#') microseconds. */
#ifndef TESTS_ROW_COSTS_H
#define TESTS_ROW_COSTS_H

enum { ROW_COSTS_ROWS = 240 };

static const struct row_costs {
    const char *scene, *rows;
} row_costs[] = {
    {"avenue", "`aacbbcb``aaababaabccbaaaaaccbbbbbbbbdeddccceecccddddcdccdddccdddcedddeddddeeeed"
               "ddddddeeeeeeeeeeeeeeeeeffffffffffffffgggggggggggggggggghhiijjkkkllmooommmmlllmnn"
               "mommmmmpmllllllllllllllllkkkkkkjihhhjjihhhghghhjiijhihhiiiihiiiiiiiijjkjiijjjjkk"},
    {"block", "@999999999999999999999:99::::9:::::::::::::::::::::;B::::;::;::;;:::::;:::::;;;;"
              ";;;;;;;;;<;;;;;;;;;;;;;;;;::;::::;;;;;;:;;;;;;;;;;;;;;;;;;;;<;;;;;;<;;;;;<;;;;;<"
              ";;;;;;;;;;;;;;;;;A<;<;;;;;<;;;;;<;;;;;;;;;;;;;;;;;:;::::;;::999:9999999998889888"},
    {"castle", "YXYWWWWWWWWWWWWXYYYWYYXWWXWWWWWWWWWWWWWWWWXWWWWXXYXWWWWXXXZXWWYYYYYYYWWXWXZXYXWY"
               "WWYWXXYYYYYYYYYYYYYYXWWXWWWXZWWXYXWXWWWWXWWYWWXWWWXWXXWXWXWWWXWWYXWWWWWWVWWWWVVW"
               "VVVVVVVWVVVWVWVVVWXWWXWXWXXXXYYZY[ZYYYYYXYXXYXXXXXXXXXYZXXXXXXXXXXXWXWWWWWWWWXWV"},
    {"chess", "ZYZYZZ[[Z[]ZYZYZYY[ZZYYYZZYYYZZZZ[[ZZZ[Z[ZZZ[[[[[[[[[]]^]]^^__^]]]]]]^^^^^____``"
              "a```aabfccccbbceddcdfcccbcededddedddddeedddddedccdddecdefdehedddfdedeedeeeedefee"
              "efededededdddddcccbbaaaaaaaa``````aaa`aa`cdaaaaa``aca`````````abba`a``__________"},
    {"clockwork", "kkkkkllllllllmmmmmmmmmmmmmmmmmoqnnnnnnnnnnnnmmnmmmmmmmmmnoqqqrrsrrrrrstuuuuvvwwv"
                  "vwwwwwwwwwvwwwxxxxxxxyxxxxxwwxxwwvvvvwwyyxxyyyxyyxxxwwxwvwwvuvvvvwuttuuuuvvvvxww"
                  "xxwvuutttssssrrqrrqrssrsrrssstrtsssssuutrstsssstsstrrrrrrrrrrqqrqppopnmomkmnnmml"},
    {"desk", "jhgjihggihhgggigffijghhhgggikinmlmlklmmnmnnmmnmmmmnonnnnmnnnmnnnnnnnopoopnnppppp"
             "pqqpqqqqrrrrssrrsrsrrssqrqsssrrsststrttssrqrsstuuuuuuuuuvvwwvyzxyzyxxyvvvvxyxwyw"
             "xxywwyyyyyyyxwvuvvwyyyyvvuvvxxwwwuttttuttxvwwxxxvuuuuuuvvvvvuvuvvvwwuuuvwvvuuvuu"},
    {"dice", "__`______________________________________`aabbcdedeefhhjkjkklklkkkmmmljjjkklllll"
             "lmllllooooonnnnoppqpqrqqrrqqqrqqqqqrrqqqrrrttrrrssusrsssttsssssrrrrsstttttttttss"
             "ssssssssqpoooooooooppqqqqqqppqpppooooponmmllllklmlmllikjjiiifffedccaa``_`_______"},
    {"fjord", "^^^^_^^^^____`__`^__a_````aaabccdddddeeeeeeeefeeeeffffgggggikkklihhiiiiijjjjmnnn"
              "nlkkkllmmljjjjjkkmlllllkkllklkkkkllklllllmllmllnlllllmmonmmmnmnmmmmmmmnnnnnnnnnn"
              "nnnnnnnnnnnnonnooopqqpoppoppoooqpopopooooooooqpopopqpooooooopooqorropoonnnnoonnn"},
    {"flake", "ZYZYYYYYZYZZZZ[[[[[[]]]__]]]]]]_]]]]]^^_`a_``aaaaaaaa``````_``aababaaaabaaa`a`aa"
              "aaabbbbbbbaabbccccbeeeeedddddbbbbbbcgcbbbbbbcb`bbbdbbcccbbcdcccdededdfegdddcecdd"
              "ddddccdhbbcbbbccbbabbbbbba```aaaaaaab``a```__```abdd``__`````aaaaaabbbbaaaabbbbb"},
    {"glass", "ZZZZZZZZZZ[Z[ZZZZZZZZZZZZZZZZ[[[[[[[[[[[[[[[[[[[[[[[[[[[[][[[][]]]]]]]]]]``abbbc"
              "cdddeeeefffffgiiiihhghgggggggggggggffffffgffffffggghhhhiiiiiiiijiijjiiiiiijiiiii"
              "iihhhhihhhiiiiiihiiihhijihhhhijkjjghjigggkjjhjjihhgggggggggggfffffhhfghhgggeeede"},
    {"knots", "QQQRQQQQQQQPQQQQRPQQQPQPPQOOOOOOOOOOOOQOOOP_ab`a``_______b`_aeffghhhiijjjjjkklmn"
              "opppppooppooooooopqrssstttttutttutuvwvvvvvvuvwwxwvvvuuuuvvvvvvvvvvvvuuuuuutvvttu"
              "vuuussrrqpqqpopooopoopommmlllkkmmmnopoppopqopqppqqqqqqqrrrrqqqqqqqqqpppppppqqrrs"},
    {"lightfield", "E@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@@AAAAABAAAAABBBBABBBBBBBBBBCCFGIIJKKMLMMNNNONOOO"
                   "PPPPPQPPPPQQQQQQQQRQQRRRRRRRRRRRRRRRQQQRRRQQQQQQRQQQQQQQQQQQRQQRQQRQQQQRRQQQQQQQ"
                   "PPPQQQQQQPPPPPRQQQRPNNNNNMMMMLMMMMMMMMMMNMMMMMMMMMMMLLLLLLLLLKKLLLLLMMMLLLMMMMMM"},
    {"marbles", "D====>>>>>>>>@@AAEGGGGGGGFFFFFFFFFFFHFFFFFFFFFFFFFFFFFFFFFFFFFFFHFFFFFFFFFFFFFHF"
                "FFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFHHHHHHIJIIIIIIIIIIIIIIJIIIKIJIIIIIIIIIIIIIIIJIII"
                "IIIIHHIIHIHHHHHHHJHHHHHHHHHJHHHHHHHHHHIHHHHHHHHHHHHHGFFFFFFFFFFHFFFFFFFFFFFFFFFF"},
    {"orrery", "A>>>>>>>>======================>===>=ACDDEEFGHKIJKLJFGFEGDBCAAAAAA@AAAAAAAHMOPPQ"
               "QRSSSSTUUUVUVVVVVWWWWWXWWXXXXXYXYXYYYZZYZZZ[]]]ZZZZ[ZZZZZZZZZZZ[[[[ZZZYYYYYZZYXX"
               "XXXXYYYYYXXXXXXXXYYYYYYYYYYYYYYYXYYXXXXXXXXXXXXXXXYYXXXXXXXXXXXXXXXXXWXXXXXXXXXX"},
    {"porch", "GDDDDDEDDDDDEDDDDDDEDDEDDEGDEDDFDEEFEEFFFFHGGFGGFFFGFFGIFGFFGFFGFFFGFFGFFGFFGFFG"
              "GGFGFFGGFGFFGFFGGGKGGFGGFGEEEEEFEEEFFEFFEFEFFEEGFEEFFEFEFFEEFFEFEHFGFFGFFGHFFHGG"
              "GGGGFFIGGGFGGFGGFHFHGFGFFGFGGFFGFHFHGFGFFGFFGFGGFGFGGGHGGGGGGGGJGGGGGGGGGGGGGGGH"},
    {"shadow-mapping", "FBABBACBABABBAJBABACBABAABABCBBCBBBCEBDBBCBBCBBCBBACBBBBBCBCCCCCBCBCCCCCCCCDEDDD"
                       "FDCEDDDDDDDDDDDDDDDEDDEDDEDDGDDEDDDEDHFFEEEDDDDEDEDFDDEDDDDDECDFDEDEDDDDFEFEEDDE"
                       "DDDEDDEEEEEEEDDDDDDEEDDDCDCCGCCECCCCCBCCBCBBCBBCBBBCCBCBBCBBCBBDBBBCBBCBDCBBCEDB"},
    {"shadow-volume", "DEBBAABAABAABAABACABBBEBACABBAACABABBACBDBBBBABBABACBFBBBCBCCCCDCCCDCCDDCDCDDDDD"
                      "DDDEDDEDDEDEJFHJJFEEEEEEEHGGFDEFDEDEDDEDEEFEEDDEDEDEDDEDDEEEFDDGDEEEGFEEDEDDEDDE"
                      "DDDDDDEDDEDDDDDDDDDHEDDCFDECFDGDIECEHEGCFDFEJ@HCHCEECCIICDCCDCCDCCCDCCDCCDCCDCCC"},
    {"solids", "KGPNPGGGHHHGGGFFFFFFJGHHFKFFGFFGGFFFFLGFHJLNQRTUVWXXXYYYYYYZ[[[[[[[[[[[[[[[[[]]]"
               "]]^^^^____```aaaaabbbbbbbbbbbcddeeeeeeeeefffffffffffffggffffgfffffffffeeeeffffee"
               "eddcba`__^^]]]^^^^^^^_^__``````a`aaa``````___^^]]][ZZYYXXWVUSSRQPOMLLLJIGFFFFFFF"},
    {"vase", "]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]^ccbbabbba```_____^^__________________```````````"
             "````aaaaaaaaaaaaaaaaaaaaaaaabaabbbbbababbbbbbbbbbbccccccccccccceeddddddddddddddc"
             "ddcdccccccccccccccccccdddddeddeeeeeeedddcccddddcdcddedeecccccba`abaaaa`__^^]]]]]"},
};

#endif
