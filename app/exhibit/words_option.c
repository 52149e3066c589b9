#include "words_option.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "words.h"

enum { SHIPPED = 4 };

static const struct {
    const char *name, *words[SHIPPED];
} OPTIONS[] = {
    /* Of growth, lightning, chemistry, and of the painting. */
    {"metaphor", {"Kind", "Espèce", "نوع", "種類"}},
    {"kind", {"Kind", "Espèce", "نوع", "種類"}},
    {"preset", {"Pattern", "Motif", "نقش", "模様"}},
    {"endpoints", {"Tips", "Pointes", "أطراف", "先端"}},
    {"eta", {"Stretch", "Élan", "امتداد", "伸び"}},
    {"particles", {"Length", "Longueur", "طول", "長さ"}},
    {"pace", {"Pace", "Allure", "سرعة", "速さ"}},
    {"life", {"Afterglow", "Lueur", "توهج", "残光"}},
    {"thickness", {"Thickness", "Épaisseur", "سُمك", "太さ"}},
    {"dimensions", {"Dimensions", "Dimensions", "أبعاد", "次元"}},
    {"turn", {"Turning", "Rotation", "دوران", "回転"}},
    {"repel", {"Distance", "Distance", "تباعد", "反発"}},
    {"feed", {"Feed", "Apport", "تغذية", "供給"}},
    {"kill", {"Kill", "Retrait", "إزالة", "除去"}},
    {"scale", {"Size", "Taille", "حجم", "大きさ"}},
    {"size", {"Size", "Taille", "حجم", "大きさ"}},
    {"steps", {"Pace", "Allure", "سرعة", "速さ"}},
    {"gradient", {"Colours", "Couleurs", "ألوان", "色"}},
    {"relief", {"Relief", "Relief", "بروز", "起伏"}},
    {"s_max", {"Density", "Densité", "كثافة", "密度"}},
    {"beta_v", {"Guidance", "Guidage", "توجيه", "導き"}},
    {"gain", {"Thickness", "Épaisseur", "سُمك", "太さ"}},
    {"radius", {"Size", "Taille", "حجم", "大きさ"}},
    {"solvent", {"Water", "Eau", "ماء", "水"}},
    {"amount", {"Ink", "Encre", "حبر", "インク"}},
    {"seed", {"Chance", "Hasard", "مصادفة", "偶然"}},
    /* Kinds of what grows. */
    {"ink", {"Ink", "Encre", "حبر", "インク"}},
    {"vine", {"Vine", "Vigne", "كرمة", "つる"}},
    {"lightning", {"Lightning", "Foudre", "صاعقة", "稲妻"}},
    {"winter", {"Winter", "Hiver", "شتاء", "冬"}},
    {"frost", {"Frost", "Givre", "صقيع", "霜"}},
    {"cracks", {"Cracks", "Craquelures", "شقوق", "ひび"}},
    {"painted", {"Painted", "Peint", "مرسوم", "絵の具"}},
    {"tesla", {"Tesla coil", "Bobine Tesla", "ملف تسلا", "テスラコイル"}},
    {"tree", {"Tree", "Arbre", "شجرة", "木"}},
    {"lichen", {"Lichen", "Lichen", "أشنة", "地衣"}},
    {"coral", {"Coral", "Corail", "مرجان", "サンゴ"}},
    {"river", {"River", "Fleuve", "نهر", "川"}},
    {"snow", {"Snow", "Neige", "ثلج", "雪"}},
    {"fracture", {"Fracture", "Fêlure", "كسر", "割れ目"}},
    {"vessels", {"Vessels", "Vaisseaux", "أوعية", "血管"}},
    {"city", {"City", "Ville", "مدينة", "街"}},
    {"lichtenberg", {"Lichtenberg", "Lichtenberg", "ليشتنبرغ", "リヒテンベルク"}},
    /* Patterns of chemistry. */
    {"wavelets", {"Wavelets", "Vaguelettes", "مويجات", "さざ波"}},
    {"voids", {"Voids", "Vides", "فراغات", "空隙"}},
    {"ripples", {"Ripples", "Rides", "تموجات", "波紋"}},
    {"honeycomb", {"Honeycomb", "Nid d’abeille", "قرص عسل", "蜂の巣"}},
    {"cells", {"Cells", "Cellules", "خلايا", "細胞"}},
    {"crowd", {"Crowd", "Foule", "زحام", "群れ"}},
    {"worms_and_spots", {"Worms and spots", "Vers et taches", "ديدان وبقع", "虫と斑点"}},
    {"fingerprint", {"Fingerprint", "Empreinte", "بصمة", "指紋"}},
    {"negatons", {"Negatons", "Négatons", "نيغاتونات", "ネガトン"}},
    {"maze", {"Maze", "Labyrinthe", "متاهة", "迷路"}},
    {"mitosis", {"Mitosis", "Mitose", "انقسام", "分裂"}},
    {"worms", {"Worms", "Vers", "ديدان", "虫"}},
    {"solitons", {"Solitons", "Solitons", "سوليتونات", "ソリトン"}},
    {"spirals", {"Spirals", "Spirales", "لوالب", "渦"}},
    {"skates", {"Skates", "Glisseurs", "متزلجات", "滑り子"}},
    {"red", {"Empty", "Vide", "فارغ", "空"}},
    {"blue", {"Full", "Plein", "ممتلئ", "満"}},
    /* Flags. */
    {"true", {"on", "oui", "نعم", "あり"}},
    {"false", {"off", "non", "لا", "なし"}},
};

const char *words_option(const char *name, int language, char *text, int size)
{
    for (size_t i = 0; i < sizeof OPTIONS / sizeof *OPTIONS; i++) {
        if (strcmp(OPTIONS[i].name, name) == 0) {
            return OPTIONS[i].words[language >= 0 && language < SHIPPED ? language : 0];
        }
    }
    snprintf(text, (size_t)size, "%s", name);
    for (char *c = text; *c; c++) {
        *c = (char)(*c == '_' ? ' ' : *c);
    }
    if (text[0] >= 'a' && text[0] <= 'z') {
        text[0] = (char)(text[0] - 'a' + 'A');
    }
    return text;
}

/* The places that tell two positions of a dial apart: a thousandth of what the key allows, at most four. */
static int places_of(const struct key *key, float value)
{
    double span = fmin(key->max - key->min, fmax(20 * fabs((double)value), 0.1));
    int places = (int)ceil(2.4 - log10(span > 0 ? span : 1));
    return key->type != KEY_NUMBER || places < 0 ? 0 : places < 4 ? places : 4;
}

/* Digits and the mark before a fraction as the language has them. */
static void write_number(const char *plain, int language, char *text, int size)
{
    const char *tag = words_languages[language].tag;
    bool arabic = strcmp(tag, "ar") == 0;
    bool comma = strcmp(tag, "fr") == 0 || strcmp(tag, "de") == 0 || strcmp(tag, "es") == 0 || strcmp(tag, "it") == 0;
    int used = 0;
    for (; *plain && used + 4 <= size; plain++) {
        if (arabic && *plain >= '0' && *plain <= '9') { /* U+0660 and on */
            text[used++] = (char)0xd9;
            text[used++] = (char)(0xa0 + (*plain - '0'));
        } else if (arabic && *plain == '.') { /* U+066B */
            text[used++] = (char)0xd9;
            text[used++] = (char)0xab;
        } else {
            text[used++] = (char)(*plain == '.' && comma ? ',' : *plain);
        }
    }
    text[used] = '\0';
}

void words_value(const struct key *key, float value, int language, char *text, int size)
{
    char plain[40];
    int whole = (int)lroundf(fminf(fmaxf(value, -2e9f), 2e9f));
    if (key->type == KEY_CHOICE || key->type == KEY_FLAG) {
        int count = 0;
        while (key->type == KEY_CHOICE && key->choices[count]) {
            count++;
        }
        bool is_choice = whole >= 0 && whole < count;
        const char *name = is_choice ? key->choices[whole] : whole ? "true" : "false";
        const char *word = words_option(name, language, plain, (int)sizeof plain);
        snprintf(text, (size_t)size, "%s", word);
        return;
    }
    snprintf(plain, sizeof plain, "%.*f", places_of(key, value), (double)value);
    write_number(plain, language, text, size);
}
